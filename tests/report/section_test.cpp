#include "report/section.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/shapes.h"

namespace gabarit {
namespace {

using shapes::Triangles;

constexpr double pi = std::numbers::pi;

Camera looking_at(const Vec3d& target, const Vec3d& toward) {
  const Vec3d any = std::fabs(toward.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0};
  Camera camera;
  camera.target = target;
  camera.right = normalized(cross(any, toward));
  camera.up = cross(normalized(toward), camera.right);
  return camera;
}

double outline_length(const Section& section) {
  double sum = 0;
  for (const SectionEdge& e : section) sum += std::hypot(e.to.x - e.from.x, e.to.y - e.from.y);
  return sum;
}

// By Green's theorem: positive, as the material lies on the left.
double outline_area(const Section& section) {
  double sum = 0;
  for (const SectionEdge& e : section) sum += (e.from.x * e.to.y - e.from.y * e.to.x) / 2;
  return sum;
}

// mm² of material by lines, or NaN when one of them does not leave it.
double scanned_area(const Section& section, double reach, double distance, double angle) {
  const PagePoint along{std::cos(angle), std::sin(angle)};
  double sum = 0;
  for (double off = -reach + distance / 2; off < reach; off += distance) {
    const auto stretches = material_along(section, {-off * along.y, off * along.x}, along);
    if (!stretches) return std::nan("");
    for (const Stretch& s : *stretches) sum += (s.to - s.from) * distance;
  }
  return sum;
}

TEST(Section, a_box_is_cut_to_its_cross_section) {
  const TriangleMesh box = shapes::mesh(shapes::box({0, 0, 0}, {10, 20, 30}));
  for (const Vec3d& toward : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}, Vec3d{-1, 0, 0}}) {
    const Vec3d extent{10, 20, 30};
    const double across = extent.x * extent.y * extent.z / std::fabs(dot(extent, toward));
    const Section section = cut(box, looking_at({4, 9, 13}, toward));
    EXPECT_NEAR(outline_area(section), across, 1e-9);
    for (const double angle : {0.0, pi / 4, 2.0})
      EXPECT_NEAR(scanned_area(section, 40, 0.25, angle), across, 0.01 * across);
  }
}

TEST(Section, a_plane_through_vertices_edges_and_whole_sides_has_a_closed_outline) {
  const TriangleMesh box = shapes::mesh(shapes::gridded_box({0, 0, 0}, {4, 4, 4}, 1));
  for (const Vec3d& toward : {Vec3d{0, 0, 1}, Vec3d{1, 1, 0}, Vec3d{1, 1, 1}, Vec3d{0, 1, 1}}) {
    const Section section = cut(box, looking_at({2, 2, 2}, normalized(toward)));
    EXPECT_NEAR(scanned_area(section, 6, 0.01, 0.3), outline_area(section), 0.02);
    EXPECT_GT(outline_area(section), 15.9);
  }
  EXPECT_EQ(cut(box, looking_at({2, 2, 4}, {0, 0, 1})).empty(), false) << "the side in the plane is its edge";
  EXPECT_TRUE(cut(box, looking_at({2, 2, 4.001}, {0, 0, 1})).empty());
}

TEST(Section, a_torus_is_cut_into_two_rings_or_two_disks) {
  const TriangleMesh torus = shapes::mesh(shapes::torus(20, 5, 360, 180));
  EXPECT_NEAR(outline_area(cut(torus, looking_at({0, 0, 0}, {0, 0, 1}))), pi * (25 * 25 - 15 * 15), 2);
  const Section disks = cut(torus, looking_at({0, 0, 0}, {0, 1, 0}));
  EXPECT_NEAR(outline_area(disks), 2 * pi * 25, 0.2);
  const auto stretches = material_along(disks, {0, 0}, {1, 0});
  ASSERT_TRUE(stretches);
  ASSERT_EQ(stretches->size(), 2U);
  EXPECT_NEAR((*stretches)[0].from, -25, 1e-2);
  EXPECT_NEAR((*stretches)[1].to, 25, 1e-2);
}

TEST(Section, material_is_where_counting_all_facets_along_a_ray_says) {
  const Triangles shape =
      shapes::joined(shapes::sphere(10, 16, 24), shapes::flipped(shapes::sphere(6, 10, 14)));
  const TriangleMesh mesh = shapes::mesh(shape);
  const Camera camera = looking_at({1, 2, 0.5}, normalized(Vec3d{1, 2, 3}));
  const Section section = cut(mesh, camera);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-12, 12);
  for (int i = 0; i < 300; ++i) {
    const PagePoint p{place(random), place(random)};
    const auto stretches = material_along(section, p, {1, 0});
    ASSERT_TRUE(stretches);
    bool inside = false;
    for (const Stretch& s : *stretches) inside = inside || (s.from < 0 && s.to > 0);
    // The solid angle of all facets, in turns.
    const Vec3d at = camera.target + p.x * camera.right + p.y * camera.up;
    double turns = 0;
    for (const shapes::Triangle& t : shape) {
      const Vec3d a = t[0] - at, b = t[1] - at, c = t[2] - at;
      const double la = length(a), lb = length(b), lc = length(c);
      turns +=
          std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb) /
          (2 * pi);
    }
    EXPECT_EQ(inside, turns > 0.5) << p.x << ' ' << p.y;
  }
}

TEST(Section, an_open_mesh_has_an_outline_and_no_material) {
  Triangles open = shapes::box({0, 0, 0}, {10, 20, 30});
  open.erase(open.begin());
  int without = 0;
  for (const Vec3d& toward : {Vec3d{1, 0.1, 0}, Vec3d{0, 1, 0.1}, Vec3d{0.1, 0, 1}}) {
    const Section section = cut(shapes::mesh(open), looking_at({4, 9, 13}, normalized(toward)));
    EXPECT_FALSE(section.empty());
    if (std::isnan(scanned_area(section, 40, 0.25, 0))) ++without;
  }
  EXPECT_GE(without, 1);
}

TEST(Section, moved_turned_and_permuted_it_stays_the_same) {
  const Triangles shape = shapes::torus(20, 5, 40, 20);
  const Vec3d target{3, 1, 2}, toward = normalized(Vec3d{2, 1, 0.5}), by{1000, -200, 30};
  const double area = outline_area(cut(shapes::mesh(shape), looking_at(target, toward)));
  const double around = outline_length(cut(shapes::mesh(shape), looking_at(target, toward)));
  const Section moved = cut(shapes::mesh(shapes::moved(shape, by)), looking_at(target + by, toward));
  EXPECT_NEAR(outline_area(moved), area, 1e-8);
  const Section mixed = cut(shapes::mesh(shapes::permuted(shape, 4)), looking_at(target, toward));
  EXPECT_NEAR(outline_area(mixed), area, 1e-9);
  EXPECT_NEAR(outline_length(mixed), around, 1e-9);
  const Vec3d axis{0, 0, 1};
  const auto turn = [](const Vec3d& v) { return Vec3d{-v.y, v.x, v.z}; };
  const Section turned =
      cut(shapes::mesh(shapes::rotated(shape, axis, pi / 2)), looking_at(turn(target), turn(toward)));
  EXPECT_NEAR(outline_area(turned), area, 1e-8);
}

TEST(Section, facets_that_are_not_finite_are_left_out) {
  Triangles shape = shapes::box({0, 0, 0}, {10, 10, 10});
  shape.push_back({Vec3d{std::nan(""), 0, 0}, Vec3d{5, 5, 5}, Vec3d{INFINITY, 1, 1}});
  EXPECT_NEAR(outline_area(cut(shapes::mesh(shape), looking_at({5, 5, 4}, {0, 0, 1}))), 100, 1e-9);
}

}  // namespace
}  // namespace gabarit
