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

// Shows the whole box from `toward` with a margin around it.
static Camera view_of(const Box3d& box, const Vec3d& toward, const Vec3d& right, double aspect) {
  constexpr double margin = 1.08;
  constexpr double largest = std::numeric_limits<double>::max() / 4;
  Camera camera;
  camera.right = right;
  camera.up = cross(toward, right);
  if (!box.empty()) {
    camera.target = box.min * 0.5 + box.max * 0.5;
    camera.width = 2 * margin * std::max(half_extent(box, right), half_extent(box, camera.up) * aspect);
  }
  camera.width = camera.width > 0 ? std::min(camera.width, largest) : 1;
  camera.height = camera.width / aspect;
  return camera;
}

// From `azimuth` radians about up, counted from the front to the left, and raised by `elevation`.
static Camera view_around(const Box3d& box, const Frame& frame, double azimuth, double elevation,
                          double aspect) {
  const Vec3d level = frame.forward * std::cos(azimuth) + frame.left() * std::sin(azimuth);
  const Vec3d toward = level * std::cos(elevation) + frame.up * std::sin(elevation);
  return view_of(box, toward, cross(frame.up, level), aspect);
}

std::vector<View> fixed_views(const Box3d& box, const Frame& frame, double aspect) {
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
