// The method of Inui, Umezu & Shimane, Shrinking sphere: A parallel algorithm for computing the thickness of
// 3D objects (2016), as the paper has it: the tests' oracle and the benchmark's baseline. And the bisection
// that the paper compares with.
#pragma once

#include <vector>

#include "gpu/bvh.h"

namespace gabarit {

struct ShrunkSphere {
  double radius = 0;
  int iterations = 0;
};

class ShrinkingSphere {
 public:
  // Binary tree of boxes, halved at the median centre along the longest side, leaves of at most four facets.
  // A contact's normal turns away from the query's by the separation angle; the paper itself has none: 1.
  ShrinkingSphere(const std::vector<Vec3d>& points, const std::vector<Primitive>& facets,
                  double cos_separation = 1);

  // Starts from half the ray's length (half the smallest side of the box when it escapes); each round takes
  // the facets within the ball, their points nearest to its centre and the smallest ball through one of them,
  // until the diameter changes by less than 1e-6 of the model's size.
  ShrunkSphere shrink(const Vec3d& point, const Vec3d& direction, std::uint32_t own) const;
  // Halves the radius while anything lies within the ball, grows it while nothing does; same start and end.
  ShrunkSphere bisect(const Vec3d& point, const Vec3d& direction, std::uint32_t own) const;

 private:
  struct Facet {
    Vec3d a, b, c, normal;
    std::uint32_t id;
  };
  struct Node {
    Vec3d min, max;
    std::uint32_t first = 0, count = 0;  // of a leaf; else count is 0 and first the second child
  };
  std::uint32_t build(std::uint32_t begin, std::uint32_t end);
  double first_radius(const Vec3d& point, const Vec3d& direction, std::uint32_t own) const;
  bool counts(const Facet& facet, const Vec3d& direction, std::uint32_t own) const;
  template <class Visit>
  void within(const Vec3d& centre, double radius, Visit&& visit) const;

  std::vector<Facet> facets_;
  std::vector<Node> nodes_;
  double size_ = 0, smallest_side_ = 0, cos_separation_;
};

}  // namespace gabarit
