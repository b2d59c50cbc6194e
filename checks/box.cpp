#include "checks/box.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace gabarit {

namespace {

double largest(const Vec3d& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Corners relative to the box's centre; `half` is its half extent.
bool separated(const Vec3d& axis, std::span<const Vec3d> corners, const Vec3d& half, double slack) {
  double low = dot(axis, corners[0]), high = low;
  for (const Vec3d& corner : corners.subspan(1)) {
    const double at = dot(axis, corner);
    low = std::min(low, at);
    high = std::max(high, at);
  }
  const double reach = std::abs(axis.x) * half.x + std::abs(axis.y) * half.y + std::abs(axis.z) * half.z +
                       slack * largest(axis);
  return low > reach || high < -reach;
}

bool finite(std::span<const Vec3d> corners) {
  return std::all_of(corners.begin(), corners.end(), [](const Vec3d& c) { return is_finite(c); });
}

Selected reaches(const Box3d& box, std::span<const Vec3d> corners) {
  if (!finite(corners)) return Selected::maybe;
  return meets(box, corners) ? Selected::yes : Selected::no;
}

Box3d box_of(const Arguments& arguments) { return {arguments.vector("from"), arguments.vector("to")}; }

Region select_box(const Scene& scene, const Setup&, const Arguments& arguments) {
  const TriangleMesh& mesh = scene.mesh();
  const Box3d box = box_of(arguments);
  Region region;
  region.facets.reserve(mesh.facet_count());
  region.edges.reserve(mesh.facet_count());
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const auto [a, b, c] = mesh.corners(f);
    region.facets.push_back(reaches(box, std::array{a, b, c}));
    region.edges.push_back(
        {reaches(box, std::array{a, b}), reaches(box, std::array{b, c}), reaches(box, std::array{c, a})});
  }
  return region;
}

std::string sentence(const Arguments& arguments) {
  const auto [from, to] = box_of(arguments);
  return fmt::format("it reaches into the box from ({}, {}, {}) to ({}, {}, {}) mm", from.x, from.y, from.z,
                     to.x, to.y, to.z);
}

}  // namespace

bool meets(const Box3d& box, std::span<const Vec3d> corners) {
  // Halves first: the sum of two huge coordinates could overflow.
  const Vec3d centre = box.min * 0.5 + box.max * 0.5;
  const Vec3d half = box.max * 0.5 - box.min * 0.5;
  std::array<Vec3d, 3> at{};
  double size = std::max(largest(box.min), largest(box.max));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    at[i] = corners[i] - centre;
    size = std::max(size, largest(corners[i]));
  }
  const std::span<const Vec3d> relative(at.data(), corners.size());
  const double slack = 1e-12 * size;
  constexpr std::array<Vec3d, 3> axes{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
  for (const Vec3d& axis : axes) {
    if (separated(axis, relative, half, slack)) return false;
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d edge = normalized(at[(i + 1) % corners.size()] - at[i]);
    for (const Vec3d& axis : axes) {
      const Vec3d across = cross(edge, axis);
      if (largest(across) > 0 && separated(across, relative, half, slack)) return false;
    }
  }
  if (corners.size() < 3) return true;
  const Vec3d normal = cross(normalized(at[1] - at[0]), normalized(at[2] - at[0]));
  return largest(normal) == 0 || !separated(normal, relative, half, slack);
}

const Selector box_selector{
    .name = "box",
    .summary = "Facets that reach into a box in the model's own coordinates.",
    .documentation =
        "A facet is selected when any part of it lies in the box, its sides included; an edge likewise. The "
        "box is "
        "parallel to the axes of the model's file; the rule file's frame and ground do not move it.\n\n"
        "The test is by separating axes (Akenine-Möller, \"Fast 3D triangle-box overlap testing\", 2001) "
        "with "
        "slack for rounding: what misses the box by less than 1e-12 of its coordinates may be selected. A "
        "facet with "
        "coordinates that are not finite is only maybe selected.",
    .parameters = {{.name = "from",
                    .dimension = Dimension::point,
                    .documentation = "The corner with the smallest coordinates."},
                   {.name = "to",
                    .dimension = Dimension::point,
                    .documentation = "The corner with the greatest coordinates."}},
    .select = select_box,
    .sentence = sentence};

}  // namespace gabarit
