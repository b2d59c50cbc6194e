#include "examples/motorcycle/placement.h"

#include <algorithm>
#include <cmath>

namespace gabarit::motorcycle {

Placement stand(const Vec3d& origin, const Vec3d& z, const Vec3d& x) {
  const Vec3d up = normalized(z);
  const Vec3d across = normalized(x - dot(x, up) * up);
  const Vec3d third = cross(up, across);
  return [=](const Vec3d& p) { return origin + p.x * across + p.y * third + p.z * up; };
}

Placement placed(Placement inner, Placement outer) {
  return [inner = std::move(inner), outer = std::move(outer)](const Vec3d& p) { return outer(inner(p)); };
}

Placement barrel(double radius, double cross_radius) {
  return [=](const Vec3d& p) {
    Vec3d section{radius + p.z, p.y, 0};  // distance from the axis, along the axis
    if (std::isfinite(cross_radius)) {
      const double angle = p.y / cross_radius, reach = cross_radius + p.z;
      section = {radius - cross_radius + reach * std::cos(angle), reach * std::sin(angle), 0};
    }
    const double around = p.x / radius;
    return Vec3d{section.x * std::sin(around), section.y, section.x * std::cos(around)};
  };
}

Placement draped(double bend_x, double bend_y, double twist) {
  return [=](const Vec3d& p) {
    const Vec3d normal = normalized(Vec3d{-bend_x * p.x - twist * p.y, -bend_y * p.y - twist * p.x, 1});
    const double height = (bend_x * p.x * p.x + bend_y * p.y * p.y) / 2 + twist * p.x * p.y;
    return Vec3d{p.x, p.y, height} + p.z * normal;
  };
}

}  // namespace gabarit::motorcycle
