#include "report/render/screen.h"

#include <algorithm>
#include <cmath>

#include "gpu/parallel_for.h"

namespace gabarit {

Screen::Screen(const Camera& camera, int width, int height)
    : target_(camera.target),
      right_(camera.right),
      up_(camera.up),
      toward_(camera.toward()),
      scale_(width * samples_per_pixel / camera.width),
      width_(width),
      height_(height) {}

bool Screen::valid() const {
  return scale_ > 0 && std::isfinite(scale_) && is_finite(target_) && is_finite(right_) && is_finite(up_);
}

Vec3d Screen::place(const Vec3d& p) const {
  const Vec3d offset = p - target_;
  return {width_ * (samples_per_pixel / 2.0) + dot(offset, right_) * scale_,
          height_ * (samples_per_pixel / 2.0) - dot(offset, up_) * scale_, dot(offset, toward_) * scale_};
}

Vec3f Screen::page_direction(const Vec3d& d) const {
  return {static_cast<float>(dot(d, right_)), static_cast<float>(dot(d, up_)),
          static_cast<float>(dot(d, toward_))};
}

static std::int32_t snapped(double samples) {
  constexpr double most = farthest_unit;
  return static_cast<std::int32_t>(std::floor(std::clamp(samples * units_per_sample, -most, most) + 0.5));
}

ScreenPoint Screen::snapped(const Vec3d& place) {
  if (!is_finite(place)) return {std::numeric_limits<std::int32_t>::min(), 0, 0};
  return {gabarit::snapped(place.x), gabarit::snapped(place.y),
          static_cast<float>(std::clamp(place.z, -1e30, 1e30))};
}

namespace {
struct SnapVertices {
  const Vec3d* vertices;
  const Screen* screen;
  ScreenPoint* points;

  void operator()(std::int64_t i) const { points[i] = Screen::snapped(screen->place(vertices[i])); }
};
}  // namespace

std::vector<ScreenPoint> on_screen(const TriangleMesh& mesh, const Screen& screen, const Device& device) {
  std::vector<ScreenPoint> points(mesh.vertices.size());
  const SnapVertices snap{mesh.vertices.data(), &screen, points.data()};
  const Device cpu = device.host();
  parallel_for(cpu, static_cast<std::int64_t>(points.size()), snap, 1 << 14);
  return points;
}

}  // namespace gabarit
