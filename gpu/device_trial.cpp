#include "gpu/device_trial.h"

#include <bit>
#include <cstdint>
#include <exception>
#include <vector>

#include "gpu/bumpy_ball.h"
#include "gpu/closest_point.h"
#include "gpu/dexel.h"
#include "gpu/distance_transform.h"
#include "gpu/maximal_sphere.h"
#include "gpu/outline_cells.h"
#include "gpu/ray_cast.h"

namespace gabarit {
namespace {

// Of all answers in a row; padding would not compare.
class Bits {
 public:
  void add(double x) { words_.push_back(std::bit_cast<std::uint64_t>(x)); }
  void add(const Vec3d& p) { add(p.x), add(p.y), add(p.z); }
  void add_number(std::uint64_t n) { words_.push_back(n); }
  friend bool operator==(const Bits&, const Bits&) = default;

 private:
  std::vector<std::uint64_t> words_;
};

struct Places {
  std::vector<SphereQuery> spheres;
  std::vector<Ray> rays;
  std::vector<Vec3d> points;
};

Places places_on(const FacetSurface& surface) {
  Places out;
  for (const Primitive& p : surface.primitives) {
    const Vec3d at =
        (surface.points[p.corner[0]] + surface.points[p.corner[1]] + surface.points[p.corner[2]]) / 3.0;
    const Vec3d in = normalized(Vec3d{-static_cast<double>(p.normal.x), -static_cast<double>(p.normal.y),
                                      -static_cast<double>(p.normal.z)});
    out.spheres.push_back({at, in, p.id, 0.01F, 0, 0});
    out.rays.push_back({at, in, p.id, 1e-6});
    out.points.push_back(at + 0.37 * in);
  }
  return out;
}

Bits spheres(const Bvh& tree, const Places& places) {
  std::vector<SphereContact> found(places.spheres.size());
  maximal_spheres(tree, {.cos_separation = -0.5, .contact_floor = 1e-6}, places.spheres, found);
  Bits bits;
  for (const SphereContact& c : found) {
    bits.add(c.radius), bits.add(c.lower), bits.add(c.upper), bits.add(c.contact);
    bits.add_number(c.primitive);
  }
  return bits;
}

Bits rays(const Bvh& tree, const Places& places) {
  std::vector<RayHit> found(places.rays.size());
  cast_rays(tree, places.rays, found);
  Bits bits;
  for (const RayHit& hit : found) bits.add(hit.distance), bits.add(hit.facing), bits.add_number(hit.facet);
  return bits;
}

Bits nearest(const Bvh& tree, const Places& places) {
  std::vector<ClosestPoint> found(places.points.size());
  closest_points(tree, places.points, found);
  Bits bits;
  for (const ClosestPoint& c : found) bits.add(c.distance), bits.add(c.point), bits.add_number(c.facet);
  return bits;
}

// Raster and distance transform.
Bits plan(const Device& device, const FacetSurface& surface) {
  std::vector<std::array<std::uint32_t, 3>> facets;
  for (const Primitive& p : surface.primitives) facets.push_back(p.corner);
  const CellGrid grid{{-20, -20}, 0.25, 160, 160};
  const OutlineCells outlines(
      device, {view(std::span(std::as_const(surface.points))), view(std::span(std::as_const(facets))), -5, 5},
      grid);
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(grid.count())), near(facets.size());
  std::vector<float> distance(cells.size());
  outlines.mark(cells);
  distance_transform(device, grid, cells, distance);
  outlines.near(distance, 0.5, near);
  Bits bits;
  for (const float d : distance) bits.add(static_cast<double>(d));
  for (const std::uint8_t n : near) bits.add_number(n);
  return bits;
}

Bits dexels(const Device& device, const FacetSurface& surface) {
  std::vector<Point2> points;
  std::vector<PlanEdge> edges;
  for (const Vec3d& p : surface.points) points.push_back({p.x, p.y});
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(points[i - 1] == points[i])) edges.push_back({points[i - 1], points[i]});
  Bits bits;
  for (const Dexel& d : offset_dexels(device, points, edges, {-20, 0.4, 100}, 3).all) {
    bits.add(d.from);
    bits.add(d.to);
  }
  return bits;
}

std::string first_difference(const Device& device) {
  const FacetSurface surface = bumpy_ball(24, 32, 10, 0.2);
  const Places places = places_on(surface);
  const Device host = device.host();
  const Bvh there(device, surface), here(host, surface);
  if (!(spheres(there, places) == spheres(here, places))) return "the largest balls";
  if (!(rays(there, places) == rays(here, places))) return "the hits of rays";
  if (!(nearest(there, places) == nearest(here, places))) return "the closest points";
  if (!(plan(device, surface) == plan(host, surface))) return "the cells of outlines and their distances";
  if (!(dexels(device, surface) == dexels(host, surface))) return "the dexels";
  return {};
}

}  // namespace

std::string trial_of(const Device& device) {
  try {
    const std::string wrong = first_difference(device);
    if (wrong.empty()) return {};
    return "CUDA device " + std::to_string(device.index) + " cannot be trusted: " + wrong +
           " differ from those of the CPU";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace gabarit
