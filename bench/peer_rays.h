// Embree's rays, when the benchmarks were built with it.
#pragma once

#include <memory>
#include <span>

#include "gpu/ray_cast.h"
#include "model/triangle_mesh.h"

namespace gabarit {

class PeerRays {
 public:
  static const bool here;

  explicit PeerRays(const TriangleMesh& mesh);
  // One ray at a time, one thread, as our own; infinite where a ray escapes.
  void cast(std::span<const Ray> rays, std::span<float> distances) const;

 private:
  std::shared_ptr<void> scene_;
};

}  // namespace gabarit
