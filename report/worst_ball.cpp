#include "report/worst_ball.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gabarit {

namespace {

bool by_ball(const Measure& measure) { return measure.name == "thickness" || measure.name == "clearance"; }

bool by_ray(const Arguments& arguments) {
  return arguments.has("method") && arguments.text("method") == "ray";
}

double nearest_limit(const Limit& limit, double value) {
  if (limit.kind == Limit::Kind::at_least) return limit.low;
  if (limit.kind == Limit::Kind::at_most) return limit.high;
  return std::fabs(value - limit.low) < std::fabs(value - limit.high) ? limit.low : limit.high;
}

// The part of `v` across the unit `axis`, as a unit vector; zero when rounding is all that there is.
Vec3d across(const Vec3d& v, const Vec3d& axis) {
  const Vec3d rest = v - dot(v, axis) * axis;
  return length(rest) > 1e-6 * length(v) ? normalized(rest) : Vec3d{};
}

// Some unit vector across the unit `axis`.
Vec3d any_across(const Vec3d& axis) {
  return std::fabs(axis.x) < 0.6 ? across({1, 0, 0}, axis) : across({0, 1, 0}, axis);
}

// A ball of this diameter through O and O + q has its centre on a circle about q; of the directions from O
// to it, the one that is nearest to `wanted`.
Vec3d direction_of(const Vec3d& q, double diameter, const Vec3d& wanted) {
  const Vec3d along = normalized(q);
  const double cosine = std::min(1.0, length(q) / diameter);
  const Vec3d aside = across(wanted, along);
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return cosine * along + sine * (aside == Vec3d{} ? any_across(along) : aside);
}

// Across the longest extent of the part, as far as the direction allows.
Vec3d free_normal(const Vec3d& direction, const Box3d& part) {
  const std::array<Vec3d, 3> axes{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
  const Vec3d extent = part.extent();
  const std::array<double, 3> lengths{extent.x, extent.y, extent.z};
  std::size_t best = 0;
  double most = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = lengths[i] * length(axes[i] - dot(axes[i], direction) * direction);
    if (share > most) best = i, most = share;
  }
  return across(axes[best], direction);
}

}  // namespace

std::optional<WorstBall> worst_ball(const TriangleMesh& mesh, const RuleResult& result, const Worst& worst) {
  const Requirement& require = result.rule.require;
  const bool known = std::isfinite(worst.value) && worst.value > 0 && is_finite(worst.at) &&
                     is_finite(worst.contact) && !(worst.at == worst.contact);
  if (require.measure == nullptr || !by_ball(*require.measure) || !known) return std::nullopt;
  const Vec3d normal = facet_normal(mesh, worst.facet);
  if (normal == Vec3d{}) return std::nullopt;
  const Vec3d q = worst.contact - worst.at;
  const bool ball = !by_ray(require.arguments);
  if (ball && length(q) > worst.value * (1 + 1e-6)) return std::nullopt;
  const Vec3d wanted = require.measure->name == "clearance" ? normal : -normal;
  return WorstBall{worst.at,    worst.contact, ball ? direction_of(q, worst.value, wanted) : normalized(q),
                   worst.value, ball,          nearest_limit(require.limit, worst.value)};
}

Camera section_camera(const WorstBall& ball, const Box3d& part, double aspect) {
  Camera camera;
  camera.up = -ball.direction;
  camera.right = across(ball.contact - ball.touch, ball.direction);
  if (camera.right == Vec3d{}) camera.right = cross(camera.up, free_normal(ball.direction, part));
  constexpr double most = 6;  // diameters: a larger limit leaves the picture, or the ball would be a dot
  const double room = std::clamp(ball.limit, ball.diameter, most * ball.diameter);
  camera.target = ball.touch + ball.direction * (room / 2);
  camera.height = 2.2 * room;
  camera.width = camera.height * aspect;
  return camera;
}

}  // namespace gabarit
