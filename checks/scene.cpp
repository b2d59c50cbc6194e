#include "checks/scene.h"

#include <mutex>

namespace gabarit {

struct Scene::Shared {
  std::once_flag adjacency_built;
  std::unique_ptr<Adjacency> adjacency;
};

Scene::Scene(const Model& model, Device device)
    : model_(&model), device_(device), shared_(std::make_shared<Shared>()) {}

const Adjacency& Scene::adjacency() const {
  std::call_once(shared_->adjacency_built,
                 [this] { shared_->adjacency = std::make_unique<Adjacency>(mesh()); });
  return *shared_->adjacency;
}

}  // namespace gabarit
