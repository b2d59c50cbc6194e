#include "report/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gabarit {

// Half the extent of the box in a direction; rounding and overflow aside, never negative.
static double half_extent(const Box3d& box, const Vec3d& direction) {
  const Vec3d half = box.max * 0.5 - box.min * 0.5;
  return half.x * std::abs(direction.x) + half.y * std::abs(direction.y) + half.z * std::abs(direction.z);
}

// Sets the width and height that show an extent on the page, with a margin around it.
static void show(Camera& camera, double width, double height, double aspect) {
  constexpr double margin = 1.08;
  constexpr double largest = std::numeric_limits<double>::max() / 4;
  camera.width = margin * std::max(width, height * aspect);
  camera.width = camera.width > 0 ? std::min(camera.width, largest) : 1;
  camera.height = camera.width / aspect;
}

static Camera view_of(const Box3d& box, const Vec3d& toward, const Vec3d& right, double aspect) {
  Camera camera;
  camera.right = right;
  camera.up = cross(toward, right);
  if (!box.empty()) camera.target = box.min * 0.5 + box.max * 0.5;
  const bool empty = box.empty();
  show(camera, empty ? 0 : 2 * half_extent(box, right), empty ? 0 : 2 * half_extent(box, camera.up), aspect);
  return camera;
}

// From `azimuth` radians about up, counted from the front to the left, and raised by `elevation`.
static Camera view_around(const Box3d& box, const Frame& frame, double azimuth, double elevation,
                          double aspect) {
  const Vec3d level = frame.forward * std::cos(azimuth) + frame.left() * std::sin(azimuth);
  const Vec3d toward = level * std::cos(elevation) + frame.up * std::sin(elevation);
  return view_of(box, toward, cross(frame.up, level), aspect);
}

std::vector<NamedView> fixed_views(const Box3d& box, const Frame& frame, double aspect) {
  const Vec3d rear = -frame.forward;
  const Vec3d left = frame.left();
  constexpr double degree = 0.017453292519943295;
  return {{"front", view_of(box, frame.forward, left, aspect)},
          {"rear", view_of(box, rear, -left, aspect)},
          {"left", view_of(box, left, rear, aspect)},
          {"right", view_of(box, -left, frame.forward, aspect)},
          {"top", view_of(box, frame.up, rear, aspect)},
          {"bottom", view_of(box, -frame.up, rear, aspect)},
          {"front left, from above", view_around(box, frame, 40 * degree, 25 * degree, aspect)},
          {"rear right, from above", view_around(box, frame, 220 * degree, 25 * degree, aspect)}};
}

// Moves the camera sideways and closer until the facets fill the picture.
static void fit(Camera& camera, const TriangleMesh& mesh, const std::vector<bool>& used, double aspect) {
  Box3d page;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const PagePoint p = project(camera, mesh.vertices[v]);
    if (used[v] && std::isfinite(p.x) && std::isfinite(p.y)) page.add(Vec3d{p.x, p.y, 0});
  }
  if (page.empty() || !is_finite(page.extent())) return;
  const Vec3d middle = page.centre();
  camera.target += camera.right * middle.x + camera.up * middle.y;
  show(camera, page.extent().x, page.extent().y, aspect);
}

std::vector<NamedView> fixed_views(const TriangleMesh& mesh, const Frame& frame, double aspect) {
  std::vector<bool> used(mesh.vertices.size());
  for (const auto& facet : mesh.facets) {
    for (const VertexId v : facet) used[v] = true;
  }
  std::vector<NamedView> views = fixed_views(bounding_box(mesh), frame, aspect);
  for (NamedView& view : views) fit(view.camera, mesh, used, aspect);
  return views;
}

Camera close_up(const Vec3d& at, const Vec3d& outward, const Frame& frame, double extent, double aspect) {
  Vec3d toward = normalized(outward);
  if (!is_finite(toward) || toward == Vec3d{}) toward = frame.forward;
  Vec3d right = normalized(cross(frame.up, toward));
  const double straight = dot(toward, frame.up);
  if (std::abs(straight) > 0.9999) {
    // From above or below, the front is on the left, as in the fixed views.
    toward = frame.up * (straight < 0 ? -1.0 : 1.0);
    right = -frame.forward;
  }
  Camera camera;
  camera.target = at;
  camera.right = right;
  camera.up = cross(toward, right);
  camera.width = extent > 0 && std::isfinite(extent) ? extent : 1;
  camera.height = camera.width / aspect;
  return camera;
}

PagePoint project(const Camera& camera, const Vec3d& point) {
  const Vec3d offset = point - camera.target;
  return {dot(offset, camera.right), dot(offset, camera.up)};
}

}  // namespace gabarit
