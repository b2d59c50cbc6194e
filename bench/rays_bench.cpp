// Rays and closest points, ours beside Embree's rays and CGAL's closest points where those are installed; the
// same points in the same run, one thread, processor time. Usage: bench_rays [GREATEST_FACETS]
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

#include "bench/facet_surface.h"
#include "bench/peer_closest_point.h"
#include "bench/peer_rays.h"
#include "gpu/closest_point.h"
#include "gpu/ray_cast.h"
#include "tests/block_solid.h"

namespace gabarit {
namespace {

constexpr double not_here = std::numeric_limits<double>::quiet_NaN();

std::string number(double x, int digits) { return std::isnan(x) ? "–" : fmt::format("{:.{}f}", x, digits); }

// Rays inwards from the middles of the facets, and the closest points to places half a millimetre inside.
void print_row(const char* name, const TriangleMesh& mesh) {
  const Bvh tree(Device::cpu(1), facet_surface(mesh));
  const double from = paper_definition(mesh).contact_floor;
  std::vector<Ray> rays;
  std::vector<Vec3d> points;
  for (const SphereQuery& q : inward_queries(mesh, tree)) {
    rays.push_back({q.point, q.direction, q.own, from});
    points.push_back(q.point + 0.5 * q.direction);
  }
  const double each = 1e6 / static_cast<double>(rays.size());
  std::vector<RayHit> hits(rays.size());
  const double ours = each * least_seconds_of([&] { cast_rays(tree, rays, hits); });
  std::vector<ClosestPoint> closest(points.size());
  const double ours_closest = each * least_seconds_of([&] { closest_points(tree, points, closest); });

  PeerRays embree(mesh);
  std::vector<float> distances(rays.size());
  const double theirs =
      PeerRays::here ? each * least_seconds_of([&] { embree.cast(rays, distances); }) : not_here;
  std::size_t apart = 0;
  for (std::size_t i = 0; PeerRays::here && i < rays.size(); ++i)
    if (!(std::fabs(static_cast<double>(distances[i]) - hits[i].distance) <= 1e-3)) ++apart;

  PeerClosestPoint cgal(mesh);
  const std::size_t stride = points.size() > 500000 ? 16 : 1;
  std::vector<double> peers(points.size());
  const double theirs_closest =
      PeerClosestPoint::here
          ? each * static_cast<double>(stride) * seconds_of([&] { cgal.distances(points, stride, peers); })
          : not_here;
  double greatest = 0;
  for (std::size_t i = 0; PeerClosestPoint::here && i < points.size(); i += stride)
    greatest = std::max(greatest, std::fabs(peers[i] - closest[i].distance));
  fmt::print("| {} | {} | {:.3f} | {} | {} | {} | {:.3f} | {} | {} | {:.0e} |\n", name, rays.size(), ours,
             number(theirs, 3), number(theirs / ours, 2), apart, ours_closest, number(theirs_closest, 2),
             number(theirs_closest / ours_closest, 1), greatest);
  std::fflush(stdout);
}

void run(double most) {
  fmt::print(
      "| part | facets | ray, ours, µs | Embree, µs | ratio | rays that differ | closest point, ours, µs | "
      "CGAL, "
      "µs | ratio | greatest difference, mm |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const double facets : {2e4, 2e5, 2e6}) {
    if (facets > most) continue;
    print_row("ribbed casting", shapes::with_facets(shapes::ribbed_casting(), facets));
    print_row("cup with a handle", shapes::with_facets(shapes::cup_with_a_handle(), facets));
    print_row("block with holes", shapes::with_facets(shapes::thick_block_with_holes(), facets));
  }
}

}  // namespace
}  // namespace gabarit

int main(int argc, char** argv) {
  gabarit::run(argc > 1 ? std::atof(argv[1]) : 2e6);
  return 0;
}
