// Surfaces that trees are built over in the tests.
#pragma once

#include <random>

#include "gpu/bvh.h"
#include "model/triangle_mesh.h"

namespace gabarit {

inline Vec3f rounded(const Vec3d& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

inline FacetSurface surface_of(const TriangleMesh& mesh) {
  FacetSurface surface;
  surface.points = mesh.vertices;
  for (FacetId f = 0; f < mesh.facet_count(); ++f)
    surface.primitives.push_back({mesh.facets[f], f, rounded(facet_normal(mesh, f)), 0});
  return surface;
}

// Facets anywhere in a cube of 10 mm, of any shape and size up to `size`; every third one is an edge instead,
// every fifth a vertex, each with a fan of two directions, those of an edge across it. Some stand on the same
// corners as others.
inline FacetSurface random_surface(std::uint32_t count, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-5, 5), step(-size, size);
  FacetSurface surface;
  const auto any = [&](auto& from) { return Vec3d{from(random), from(random), from(random)}; };
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto first = static_cast<std::uint32_t>(surface.points.size());
    const Vec3d a = i % 7 == 6 ? surface.points[first - 3] : any(place);
    surface.points.insert(surface.points.end(), {a, a + any(step), a + any(step)});
    Primitive p{{first, first + 1, first + 2}, i, {}, 0};
    if (i % 3 != 0 && i % 5 != 0) {
      const Vec3d* const at = &surface.points[first];
      p.normal = rounded(normalized(cross(at[1] - at[0], at[2] - at[0])));
    } else {
      p.corner[2] = static_cast<std::uint32_t>(surface.fan_first.size() - 1);
      if (i % 3 != 0) p.corner[1] = first;
      const Vec3d along = surface.points[p.corner[1]] - a;
      for (int k = 0; k < 2; ++k) {
        const Vec3d w = any(step);
        surface.fan_directions.push_back(rounded(normalized(along == Vec3d{} ? w : cross(along, w))));
      }
      surface.fan_first.push_back(static_cast<std::uint32_t>(surface.fan_directions.size()));
    }
    surface.primitives.push_back(p);
  }
  return surface;
}

}  // namespace gabarit
