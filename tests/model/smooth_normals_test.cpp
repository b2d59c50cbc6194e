#include "model/smooth_normals.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "model/facet_normals.h"
#include "tests/shapes.h"

namespace gabarit {
namespace {

using shapes::Triangles;

constexpr double degree = std::numbers::pi / 180, crease = 40 * degree;
const Device one = Device::cpu(1);

Vec3d to_double(const Vec3f& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
std::vector<std::array<Vec3f, 3>> normals_at_corners(const TriangleMesh& mesh, double least_crease,
                                                     const Device& device) {
  return smooth_normals(mesh, facet_normals(mesh, device), least_crease, device);
}
double angle(const Vec3d& a, const Vec3d& b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

// The widest angle, in degrees, between the normals at the corners and the surface's own.
template <class Truth>
double widest(const Triangles& shape, const Truth& truth) {
  const TriangleMesh mesh = shapes::mesh(shape);
  const auto normals = normals_at_corners(mesh, crease, one);
  double most = 0;
  for (FacetId f = 0; f < mesh.facet_count(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d n = truth(mesh.corner(f, static_cast<int>(k)), facet_normal(mesh, f));
      if (n != Vec3d{}) most = std::max(most, angle(to_double(normals[f][k]), n) / degree);
    }
  return most;
}

Vec3d of_rod(const Vec3d& p, const Vec3d& facet) {
  return std::fabs(facet.z) > 0.9 ? Vec3d{0, 0, facet.z > 0 ? 1.0 : -1.0} : normalized(Vec3d{p.x, p.y, 0});
}

TEST(SmoothNormals, of_a_box_are_those_of_its_facets) {
  EXPECT_LT(
      widest(shapes::gridded_box({0, 0, 0}, {5, 4, 3}, 1), [](const Vec3d&, const Vec3d& n) { return n; }),
      1e-5);
}

TEST(SmoothNormals, of_a_rod_are_radial_and_its_ends_stay_flat) {
  for (const int segments : {12, 36, 90})
    EXPECT_LT(widest(shapes::revolve({{0, 0}, {5, 0}, {5, 20}, {0, 20}}, segments), of_rod), 1e-4)
        << segments;
}

TEST(SmoothNormals, of_a_ball_are_radial) {
  EXPECT_LT(widest(shapes::sphere(10, 20, 40), [](const Vec3d& p, const Vec3d&) { return normalized(p); }),
            2);
}

// Strips of which one half is cut into slivers: those weigh less than the whole, but what is left is within
// the tilt that the bounds of thickness allow for.
TEST(SmoothNormals, slivers_pull_them_aside_by_half_the_bend_at_most) {
  Triangles shape;
  constexpr int segments = 24, cuts = 40;
  for (int i = 0; i < segments; ++i) {
    const double a = 2 * std::numbers::pi * i / segments, b = 2 * std::numbers::pi * (i + 1) / segments;
    const Vec3d p{5 * std::cos(a), 5 * std::sin(a), 0}, q{5 * std::cos(b), 5 * std::sin(b), 0};
    const Vec3d up{0, 0, 20};
    shape.push_back({p, q, q + up});
    for (int k = 0; k < cuts; ++k)
      shape.push_back({p, q + up - (q - p) * (static_cast<double>(k) / cuts),
                       q + up - (q - p) * (static_cast<double>(k + 1) / cuts)});
  }
  const TriangleMesh mesh = shapes::mesh(shape);
  const auto normals = normals_at_corners(mesh, crease, one);
  double most = 0;
  for (FacetId f = 0; f < mesh.facet_count(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d at = mesh.corner(f, static_cast<int>(k));
      if (std::fabs(std::hypot(at.x, at.y) - 5) > 1e-9) continue;  // between two corners of the polygon
      most = std::max(most, angle(to_double(normals[f][k]), normalized(Vec3d{at.x, at.y, 0})) / degree);
    }
  EXPECT_LT(most, 15.0 / 2 + 1e-3);
}

TEST(SmoothNormals, a_crease_wider_than_asked_for_stays_sharp_and_a_narrower_one_is_rounded) {
  const auto bend = [](double degrees) {
    const double c = 10 * std::cos(degrees * degree), s = 10 * std::sin(degrees * degree);
    return shapes::mesh({{Vec3d{-10, 0, 0}, Vec3d{0, 0, 0}, Vec3d{0, 10, 0}},
                         {Vec3d{0, 0, 0}, Vec3d{c, 0, -s}, Vec3d{0, 10, 0}}});
  };
  const auto sharp = normals_at_corners(bend(41), crease, one),
             round = normals_at_corners(bend(39), crease, one);
  EXPECT_NEAR(angle(to_double(sharp[0][1]), {0, 0, 1}) / degree, 0, 1e-3);
  EXPECT_GT(angle(to_double(round[0][1]), {0, 0, 1}) / degree, 10);
}

TEST(SmoothNormals, facets_without_a_normal_have_none_and_pull_nothing) {
  Triangles shape = shapes::box({0, 0, 0}, {5, 4, 3});
  shape.push_back({Vec3d{0, 0, 0}, Vec3d{5, 0, 0}, Vec3d{2.5, 0, 0}});
  const auto normals = normals_at_corners(shapes::mesh(shape), crease, one);
  EXPECT_EQ(normals.back()[0], Vec3f{});
  for (std::size_t f = 0; f + 1 < shape.size(); ++f) EXPECT_NEAR(length(to_double(normals[f][0])), 1, 1e-6);
}

TEST(SmoothNormals, turned_permuted_and_on_any_number_of_threads_they_stay_the_same) {
  const Triangles shape = shapes::torus(12, 4, 20, 14);
  const Vec3d axis = normalized(Vec3d{1, 2, 3});
  const auto as_is = normals_at_corners(shapes::mesh(shape), crease, one);
  EXPECT_EQ(normals_at_corners(shapes::mesh(shape), crease, Device::cpu(5)), as_is);
  const auto turned = normals_at_corners(shapes::mesh(shapes::rotated(shape, axis, 0.7)), crease, one);
  for (std::size_t f = 0; f < shape.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d n = to_double(as_is[f][k]);
      const Vec3d expected =
          std::cos(0.7) * n + std::sin(0.7) * cross(axis, n) + (1 - std::cos(0.7)) * dot(axis, n) * axis;
      EXPECT_LT(angle(to_double(turned[f][k]), expected), 1e-5);
    }
  }
  std::vector<std::uint32_t> order;
  const Triangles mixed = shapes::permuted(shape, 3, &order);
  const auto normals = normals_at_corners(shapes::mesh(mixed), crease, one);
  for (std::size_t f = 0; f < mixed.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j)
        if (mixed[f][k] == shape[order[f]][j]) {
          EXPECT_LT(angle(to_double(normals[f][k]), to_double(as_is[order[f]][j])), 1e-5);
        }
}

}  // namespace
}  // namespace gabarit
