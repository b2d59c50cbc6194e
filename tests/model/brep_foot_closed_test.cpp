#include "model/brep_foot_closed.h"

#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace gabarit {
namespace {

constexpr double pi = std::numbers::pi;

// One face that is all of a surface, as far as a hundred times its size; of a cone one side.
struct OneFace {
  Brep brep;
  BrepView arrays;

  OneFace(SurfaceKind kind, double radius, double minor, const Axes& axes) {
    Surface s;
    s.kind = kind, s.axes = axes, s.radius = radius, s.minor = minor;
    s.u_periodic = kind != SurfaceKind::plane, s.v_periodic = kind == SurfaceKind::torus;
    const double far = 1000, top = kind == SurfaceKind::sphere  ? pi / 2
                                   : kind == SurfaceKind::torus ? pi
                                                                : far;
    s.domain = s.u_periodic ? ParameterBox{0, 2 * pi, -top, top} : ParameterBox{-far, far, -far, far};
    if (kind == SurfaceKind::cone) s.domain.v0 = apex_of(s);  // one side of it
    brep.surfaces = {s};
    Face face;
    face.surface = 0, face.range = s.domain;
    brep.faces = {face};
    arrays = view(brep);
  }
  const Face& face() const { return brep.faces[0]; }
  SurfacePoint at(Parameters p) const { return face_point(arrays, face(), p); }
};

class Chance {
 public:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec3d direction() {
    Vec3d v;
    do v = {between(-1, 1), between(-1, 1), between(-1, 1)};
    while (squared_length(v) > 1 || squared_length(v) < 0.01);
    return normalized(v);
  }
  // Anywhere; every other one left-handed.
  Axes axes() {
    Axes a;
    a.z = direction();
    a.x = normalized(cross(a.z, direction()));
    a.y = cross(a.z, a.x) * (between(0, 1) < 0.5 ? 1.0 : -1.0);
    a.origin = {between(-50, 50), between(-50, 50), between(-50, 50)};
    return a;
  }

 private:
  std::mt19937 random_{11};
};

const std::vector<std::array<double, 3>> kinds{{static_cast<double>(SurfaceKind::plane), 0, 0},
                                               {static_cast<double>(SurfaceKind::sphere), 4, 0},
                                               {static_cast<double>(SurfaceKind::cylinder), 4, 0},
                                               {static_cast<double>(SurfaceKind::cone), 3, 0.4},
                                               {static_cast<double>(SurfaceKind::torus), 6, 2}};

Parameters random_place(const OneFace& one, Chance& chance) {
  const ParameterBox& d = one.face().range;
  const double most = 30;  // mm, where the surface has no end
  return {chance.between(std::max(d.u0, -most), std::min(d.u1, most)),
          chance.between(std::max(d.v0, -most), std::min(d.v1, most))};
}

// The smallest ball of the feet and of the rim where the normal counts.
double least_of(const OneFace& one, const Pencil& pencil, double least_facing) {
  const ClosedFootSearch search(one.brep.surfaces[0], pencil, 100);
  ClosedFeet feet;
  search.add_feet(feet);
  search.add_rim(one.face(), pencil.direction, least_facing, feet);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < feet.count; ++i) {
    const FaceFoot foot = known_foot(one.arrays, one.face(), pencil, feet.at[i]);
    const Vec3d n = outward_normal_at(one.arrays, one.face(), foot.surface);
    if (dot(n, pencil.direction) >= least_facing - 1e-6) least = std::min(least, foot.radius);
  }
  // The tip of a cone is no foot.
  if (one.brep.surfaces[0].kind == SurfaceKind::cone)
    least = std::min(least, ball_of(pencil, one.at({0, one.face().range.v0}).p).radius);
  return least;
}

TEST(ClosedFeet, they_touch_the_surface) {
  Chance chance;
  for (const auto& [kind, radius, minor] : kinds) {
    int found = 0;
    for (int i = 0; i < 300; ++i) {
      const OneFace one(static_cast<SurfaceKind>(kind), radius, minor, chance.axes());
      const Vec3d near = one.brep.surfaces[0].axes.origin;
      const Pencil pencil{near + chance.between(1, 20) * chance.direction(), chance.direction()};
      ClosedFeet feet;
      ClosedFootSearch(one.brep.surfaces[0], pencil, 100).add_feet(feet);
      for (int k = 0; k < feet.count; ++k) {
        const FaceFoot foot = known_foot(one.arrays, one.face(), pencil, feet.at[k]);
        if (!foot.found || foot.radius > 1000) continue;
        EXPECT_LT(foot.residual, 1e-8 * (1 + foot.radius)) << "kind " << kind << " pencil " << i;
        ++found;
      }
    }
    EXPECT_GT(found, 100) << "kind " << kind;
  }
}

TEST(ClosedFeet, no_point_of_the_surface_that_counts_is_nearer) {
  Chance chance;
  for (const auto& [kind, radius, minor] : kinds) {
    // The rim of a torus has no closed form: there everything counts.
    const bool torus = static_cast<SurfaceKind>(kind) == SurfaceKind::torus;
    for (const double least_facing : {-1.0, torus ? -1.0 : 0.5, torus ? -1.0 : -0.94}) {
      for (int i = 0; i < 60; ++i) {
        const OneFace one(static_cast<SurfaceKind>(kind), radius, minor, chance.axes());
        const Vec3d near = one.brep.surfaces[0].axes.origin;
        const Pencil pencil{near + chance.between(1, 20) * chance.direction(), chance.direction()};
        const double least = least_of(one, pencil, least_facing);
        for (int k = 0; k < 3000; ++k) {
          const SurfacePoint s = one.at(random_place(one, chance));
          const Vec3d n = outward_normal_at(one.arrays, one.face(), s);
          if (n == Vec3d{} || dot(n, pencil.direction) < least_facing) continue;
          EXPECT_GE(ball_of(pencil, s.p).radius, least * (1 - 1e-9))
              << "kind " << kind << " facing " << least_facing << " pencil " << i;
        }
      }
    }
  }
}

// All of the surface's circle or sphere through the point is equally near: the opposite place stands for it.
TEST(ClosedFeet, a_point_of_the_surface_itself_finds_the_opposite_side) {
  Chance chance;
  for (const auto& [kind, radius, minor] : kinds) {
    if (static_cast<SurfaceKind>(kind) == SurfaceKind::plane) continue;
    for (int i = 0; i < 50; ++i) {
      const OneFace one(static_cast<SurfaceKind>(kind), radius, minor, chance.axes());
      const double v = chance.between(-1, 1);
      const SurfacePoint s = one.at({chance.between(0, 2 * pi), v});
      const Vec3d n = outward_normal_at(one.arrays, one.face(), s);
      const Surface& surface = one.brep.surfaces[0];
      const double hand = dot(cross(surface.axes.x, surface.axes.y), surface.axes.z);
      const Pencil pencil{s.p, -hand * n};
      const double across = static_cast<SurfaceKind>(kind) == SurfaceKind::cone
                                ? (radius + v * std::sin(minor)) / std::cos(minor)
                            : static_cast<SurfaceKind>(kind) == SurfaceKind::torus ? minor
                                                                                   : radius;
      ClosedFeet feet;
      ClosedFootSearch(surface, pencil, 100).add_feet(feet);
      double farthest = 0;
      for (int k = 0; k < feet.count; ++k) {
        const FaceFoot foot = known_foot(one.arrays, one.face(), pencil, feet.at[k]);
        if (length(foot.surface.p - s.p) > 1e-3 && foot.found)
          farthest = std::abs(foot.radius - across) < 1e-9 ? across : farthest;
      }
      EXPECT_EQ(farthest, across) << "kind " << kind;
    }
  }
}

}  // namespace
}  // namespace gabarit
