// A closed bumpy ball of any number of facets, to try devices, tests and benchmarks on.
#pragma once

#include <cmath>
#include <numbers>

#include "gpu/bvh.h"

namespace gabarit {

// `bumps`: height of the bumps as a share of the radius; 0 gives a ball.
inline FacetSurface bumpy_ball(int rings, int segments, double radius, double bumps,
                               const Vec3d& centre = {}) {
  FacetSurface surface;
  const auto point = [&](int ring, int segment) {
    const double theta = std::numbers::pi * ring / rings;
    const double phi = 2 * std::numbers::pi * (segment % segments) / segments;
    const double r = radius * (1 + bumps * std::sin(5 * theta) * std::cos(4 * phi));
    return centre +
           r * Vec3d{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
  };
  const auto add = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const auto first = static_cast<std::uint32_t>(surface.points.size());
    const Vec3d n = normalized(cross(b - a, c - a));
    surface.points.insert(surface.points.end(), {a, b, c});
    surface.primitives.push_back({{first, first + 1, first + 2},
                                  static_cast<std::uint32_t>(surface.primitives.size()),
                                  {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)},
                                  0.0F});
  };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < segments; ++j) {
      const Vec3d a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1), d = point(i, j + 1);
      if (i + 1 < rings) add(a, b, c);
      if (i > 0) add(a, c, d);
    }
  }
  return surface;
}

}  // namespace gabarit
