// The closest points of CGAL's AABB tree. That package is under the GPL, which a program that is handed on
// would fall under too: benchmarks are never installed, and nothing but this file's source names it.
#pragma once

#include <memory>
#include <span>

#include "model/triangle_mesh.h"

namespace gabarit {

class PeerClosestPoint {
 public:
  static const bool here;

  explicit PeerClosestPoint(const TriangleMesh& mesh);
  // Of every so many-th point.
  void distances(std::span<const Vec3d> points, std::size_t stride, std::span<double> distances) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

}  // namespace gabarit
