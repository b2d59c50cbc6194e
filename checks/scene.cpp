#include "checks/scene.h"

#include <map>
#include <mutex>

#include "checks/exact_surface.h"

namespace gabarit {

struct Scene::Shared {
  std::once_flag adjacency_built;
  std::unique_ptr<Adjacency> adjacency;
  std::mutex surfaces_guard;
  std::map<SurfaceOptions, ContactSurface> surfaces;  // references stay good while it grows
  std::once_flag exact_model_built;
  std::unique_ptr<ExactModel> exact_model;
  std::map<Side, ExactSurface> exact_surfaces;  // likewise
};

Scene::Scene(const Model& model, Device device)
    : model_(&model), device_(device), shared_(std::make_shared<Shared>()) {}

const Adjacency& Scene::adjacency() const {
  std::call_once(shared_->adjacency_built, [this] {
    shared_->adjacency = std::make_unique<Adjacency>(mesh(), std::span<const FacetId>{}, 1e-3, device());
  });
  return *shared_->adjacency;
}

const ExactModel& Scene::exact_model() const {
  std::call_once(shared_->exact_model_built,
                 [this] { shared_->exact_model = std::make_unique<ExactModel>(*model_, device_); });
  return *shared_->exact_model;
}

const ExactSurface& Scene::exact_surface(Side side) const {
  const ExactModel& exact = exact_model();
  const std::lock_guard lock(shared_->surfaces_guard);
  auto place = shared_->exact_surfaces.find(side);
  if (place == shared_->exact_surfaces.end())
    place = shared_->exact_surfaces.emplace(side, gabarit::exact_surface(exact, side)).first;
  return place->second;
}

const ContactSurface& Scene::surface(const SurfaceOptions& options) const {
  const Adjacency& neighbours = adjacency();
  const std::lock_guard lock(shared_->surfaces_guard);
  auto place = shared_->surfaces.find(options);
  if (place == shared_->surfaces.end())
    place = shared_->surfaces.emplace(options, contact_surface(mesh(), neighbours, options, device_)).first;
  return place->second;
}

}  // namespace gabarit
