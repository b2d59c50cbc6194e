// Gives equal coordinates one vertex number, in the order of first appearance.
#pragma once

#include <span>
#include <vector>

#include "model/triangle_mesh.h"

namespace gabarit {

// Open addressing over the vertices themselves; linear, no allocation a vertex. -0 and 0 are equal; points
// that are not finite are never equal to anything.
class VertexWeld {
 public:
  explicit VertexWeld(std::vector<Vec3d>& vertices, std::size_t expected = 0);

  // The vertex numbers of `points`, in order. Looking up many at once hides the memory's latency.
  void add(std::span<const Vec3d> points, VertexId* numbers);

 private:
  void grow();
  VertexId find_or_add(const Vec3d& point, std::size_t slot);

  std::vector<Vec3d>* vertices_;
  std::vector<VertexId> slots_;  // number + 1; 0: free
  std::size_t mask_ = 0;
};

}  // namespace gabarit
