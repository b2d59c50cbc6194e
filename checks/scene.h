// A model made ready for measuring: what several checks need is built once and shared.
#pragma once

#include <functional>
#include <memory>

#include "checks/contact_surface.h"
#include "checks/frame.h"
#include "checks/interval.h"
#include "gpu/device.h"
#include "model/adjacency.h"
#include "model/model.h"

namespace gabarit {

class ExactModel;
struct ExactSurface;

class Scene {
 public:
  Scene(const Model& model, Device device);

  const Model& model() const { return *model_; }
  const TriangleMesh& mesh() const { return model_->mesh; }
  const Device& device() const { return device_; }
  // Adjacency of the whole mesh through T-junctions; built at the first call, safe from several threads.
  const Adjacency& adjacency() const;
  // The tree that balls and rays are sent through, by its options; built at the first call, safe likewise.
  const ContactSurface& surface(const SurfaceOptions& options) const;
  // The exact faces of a model that has them, and what balls and rays meet from one side of them; built at
  // the first call, safe likewise.
  const ExactModel& exact_model() const;
  const ExactSurface& exact_surface(Side side) const;

 private:
  struct Shared;
  const Model* model_;
  Device device_;
  std::shared_ptr<Shared> shared_;
};

// Which value of a facet that has several is wanted: a limit from below asks for the smallest.
enum class Extreme { smallest, greatest };

// What a rule file says about the model and the place a selector stands in.
struct Setup {
  Frame frame;
  double sag = 0.1;      // mm
  Interval height_band;  // above ground: `height` selectors beside a contact say how far the probe reaches
  Extreme extreme = Extreme::smallest;
  double limit = 0;                               // mm: what the value is compared with; 0: nothing
  double resolution = 0;                          // mm: how finely the rule looks at large facets; 0: no rule
  std::function<void(double fraction)> progress;  // may be empty
};

}  // namespace gabarit
