#include "bench/peer_closest_point.h"

#ifdef GABARIT_HAS_CGAL_TREE
#include <cmath>
#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#endif

namespace gabarit {

#ifdef GABARIT_HAS_CGAL_TREE
using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Member = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

struct PeerClosestPoint::Tree {
  Triangles triangles;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Member>> tree;
};

const bool PeerClosestPoint::here = true;

PeerClosestPoint::PeerClosestPoint(const TriangleMesh& mesh) {
  const auto made = std::make_shared<Tree>();
  const auto point = [](const Vec3d& p) { return Kernel::Point_3(p.x, p.y, p.z); };
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const auto corners = mesh.corners(f);
    made->triangles.emplace_back(point(corners[0]), point(corners[1]), point(corners[2]));
  }
  made->tree.insert(made->triangles.cbegin(), made->triangles.cend());
  made->tree.build();
  made->tree.accelerate_distance_queries();
  tree_ = made;
}

void PeerClosestPoint::distances(std::span<const Vec3d> points, std::size_t stride,
                                 std::span<double> distances) const {
  for (std::size_t i = 0; i < points.size(); i += stride)
    distances[i] = std::sqrt(tree_->tree.squared_distance({points[i].x, points[i].y, points[i].z}));
}
#else
struct PeerClosestPoint::Tree {};
const bool PeerClosestPoint::here = false;
PeerClosestPoint::PeerClosestPoint(const TriangleMesh&) {}
void PeerClosestPoint::distances(std::span<const Vec3d>, std::size_t, std::span<double>) const {}
#endif

}  // namespace gabarit
