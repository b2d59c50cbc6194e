#include "checks/scene.h"

#include <map>
#include <mutex>

#include "checks/exact_surface.h"

namespace gabarit {

struct Scene::Shared {
  std::once_flag adjacency_built;
  std::unique_ptr<Adjacency> adjacency;
  std::mutex surfaces_guard;
  std::map<SurfaceOptions, ContactSurface> surfaces, surfaces_here;  // references stay good while they grow
  std::map<Side, ExactSurface> exact_surfaces;                       // likewise

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
  std::call_once(shared_->adjacency_built, [this] {
    shared_->adjacency = std::make_unique<Adjacency>(mesh(), std::span<const FacetId>{}, 1e-3, device());
  });
  return *shared_->adjacency;
}

// Of the CPU: it alone follows exact surfaces.
const ExactSurface& Scene::exact_surface(Side side) const {
  const std::lock_guard lock(shared_->surfaces_guard);
  auto place = shared_->exact_surfaces.find(side);
  if (place == shared_->exact_surfaces.end())
    place =
        shared_->exact_surfaces.emplace(side, gabarit::exact_surface(*model_, side, device_.host())).first;
  return place->second;
}

const ContactSurface& Scene::surface(const SurfaceOptions& options) const {
  return shared_->built(shared_->surfaces, options, *this, device_);
}

const ContactSurface& Scene::surface_here(const SurfaceOptions& options) const {
  if (!device_.has_own_memory()) return surface(options);
  return shared_->built(shared_->surfaces_here, options, *this, device_.host());
}

}  // namespace gabarit
