#include "checks/scene.h"

#include <map>
#include <mutex>

namespace gabarit {

struct Scene::Shared {
  std::once_flag adjacency_built;
  std::unique_ptr<Adjacency> adjacency;
  std::once_flag edges_built, leans_built;
  std::unique_ptr<EdgeChords> edges;
  std::vector<float> leans;
  std::mutex surfaces_guard;
  std::map<SurfaceOptions, ContactSurface> surfaces, surfaces_here;  // references stay good while they grow

  const ContactSurface& built(std::map<SurfaceOptions, ContactSurface>& known, const SurfaceOptions& options,
                              const Scene& scene, const Device& device) {
    const Adjacency& neighbours = scene.adjacency();
    const std::lock_guard lock(surfaces_guard);
    auto place = known.find(options);
    if (place == known.end()) {
      place = known.emplace(options, contact_surface(scene.mesh(), neighbours, options, device)).first;
    }
    return place->second;
  }
};

Scene::Scene(const Model& model, Device device)
    : model_(&model), device_(device), shared_(std::make_shared<Shared>()) {}

const Adjacency& Scene::adjacency() const {
  std::call_once(shared_->adjacency_built,
                 [this] { shared_->adjacency = std::make_unique<Adjacency>(mesh()); });
  return *shared_->adjacency;
}

const EdgeChords& Scene::edges() const {
  std::call_once(shared_->edges_built, [this] {
    shared_->edges = std::make_unique<EdgeChords>(edge_chords(model(), Device::cpu()));
  });
  return *shared_->edges;
}

const std::vector<float>& Scene::facet_leans() const {
  std::call_once(shared_->leans_built, [this] { shared_->leans = gabarit::facet_leans(model(), device_); });
  return shared_->leans;
}

const ContactSurface& Scene::surface(const SurfaceOptions& options) const {
  return shared_->built(shared_->surfaces, options, *this, device_);
}

const ContactSurface& Scene::surface_here(const SurfaceOptions& options) const {
  if (!device_.has_own_memory()) return surface(options);
  return shared_->built(shared_->surfaces_here, options, *this, device_.host());
}

}  // namespace gabarit
