#include "report/render/tile_bins.h"

#include <algorithm>
#include <random>

#include <gmock/gmock.h>

#include "report/render/clip.h"
#include "tests/report/picture_checks.h"

namespace gabarit {
namespace {

TEST(tile_bins, list_every_facet_in_every_tile_that_its_box_meets) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> at(-120, 120);
  std::uniform_real_distribution<double> size(0, 30);
  shapes::Triangles triangles;
  for (int i = 0; i < 400; ++i) {
    const Vec3d p{at(random), at(random), 0};
    triangles.push_back({p, p + Vec3d{size(random), 0, 1}, p + Vec3d{0, size(random), 2}});
  }
  const TriangleMesh mesh = shapes::mesh(triangles);
  const Screen screen(from_above(200, 2), 400, 200);
  const auto points = on_screen(mesh, screen, Device::cpu(1));
  const TileBins bins(mesh, points, {}, screen, Device::cpu(1));
  EXPECT_EQ(bins.columns(), 7);
  EXPECT_EQ(bins.tiles(), 28);
  for (int tile = 0; tile < bins.tiles(); ++tile) {
    EXPECT_TRUE(std::is_sorted(bins.of(tile).begin(), bins.of(tile).end()));
    const int left = tile % 7 * 64;
    const int top = tile / 7 * 64;
    for (FacetId f = 0; f < mesh.facet_count(); ++f) {
      const Vec3d p = triangles[f][0];
      const double width = triangles[f][1].x - p.x;
      const double height = triangles[f][2].y - p.y;
      const double x = 2 * p.x + 200;
      const double y = 100 - 2 * p.y;
      const bool meets = x + 2 * width >= left && x <= left + 64 && y >= top && y - 2 * height <= top + 64;
      const bool listed = std::binary_search(bins.of(tile).begin(), bins.of(tile).end(), f) ||
                          std::binary_search(bins.large().begin(), bins.large().end(), f);
      EXPECT_TRUE(listed || !meets || width < 0.25 || height < 0.25);
    }
  }
}

TEST(tile_bins, are_the_same_on_any_number_of_threads) {
  const TriangleMesh mesh = shapes::mesh(shapes::sphere(80, 150, 300));
  const Screen screen(from_above(200), 300, 300);
  const auto points = on_screen(mesh, screen, Device::cpu(1));
  const TileBins a(mesh, points, {}, screen, Device::cpu(1));
  const TileBins b(mesh, points, {}, screen, Device::cpu(3));
  for (int tile = 0; tile < a.tiles(); ++tile) EXPECT_TRUE(std::ranges::equal(a.of(tile), b.of(tile)));
  EXPECT_TRUE(std::ranges::equal(a.large(), b.large()));
}

TEST(tile_bins, list_a_facet_that_covers_everything_only_once) {
  const TriangleMesh mesh = shapes::mesh({{Vec3d{-900, -900, 0}, Vec3d{900, -900, 0}, Vec3d{0, 900, 0}},
                                          {Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{0, 1, 0}}});
  const Screen screen(from_above(100), 1000, 1000);
  const TileBins bins(mesh, on_screen(mesh, screen, Device::cpu(1)), {}, screen, Device::cpu(1));
  EXPECT_THAT(bins.large(), testing::ElementsAre(0U));
  std::size_t entries = 0;
  for (int tile = 0; tile < bins.tiles(); ++tile) entries += bins.of(tile).size();
  EXPECT_LE(entries, 4U);
  EXPECT_GE(entries, 1U);
}

TEST(tile_bins, leave_out_facets_between_the_samples_unless_they_are_marked) {
  const TriangleMesh mesh = shapes::mesh({{Vec3d{0, 0, 0}, Vec3d{1e-4, 0, 0}, Vec3d{0, 1e-4, 0}}});
  const Screen screen(from_above(100), 100, 100);
  const auto points = on_screen(mesh, screen, Device::cpu(1));
  const auto entries = [&](std::vector<std::uint8_t> marked) {
    const TileBins bins(mesh, points, marked, screen, Device::cpu(1));
    std::size_t sum = 0;
    for (int tile = 0; tile < bins.tiles(); ++tile) sum += bins.of(tile).size();
    return sum;
  };
  EXPECT_EQ(entries({}), 0U);
  EXPECT_EQ(entries({0}), 0U);
  EXPECT_GE(entries({2}), 1U);
}

double area(const std::vector<Vec3d>& polygon) {
  Vec3d sum;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]) * 0.5;
  }
  return std::abs(sum.z);
}

TEST(clipped, keeps_the_part_in_the_rectangle_with_its_depth) {
  const std::vector<Vec3d> triangle{{0, 0, 0}, {4, 0, 4}, {0, 4, 0}};  // z = x
  const auto part = clipped(triangle, 1, -1, 5, 1);
  EXPECT_NEAR(area(part), 2.5, 1e-12);  // of the trapezium from (1, 0) to (4, 0), cut at y = 1
  for (const Vec3d& p : part) EXPECT_NEAR(p.z, p.x, 1e-12);
}

TEST(clipped, leaves_what_is_inside_and_drops_what_is_outside) {
  const std::vector<Vec3d> triangle{{0, 0, 0}, {4, 0, 4}, {0, 4, 0}};
  EXPECT_EQ(clipped(triangle, -1, -1, 5, 5), triangle);
  EXPECT_TRUE(clipped(triangle, 5, 5, 9, 9).empty());
}

TEST(clipped, holds_for_corners_at_the_end_of_the_world) {
  const auto part = clipped({{-1e308, -1e308, 0}, {1e308, -1e308, 0}, {0, 1e308, 0}}, -1, -1, 1, 1);
  EXPECT_NEAR(area(part), 4, 1e-9);
}

}  // namespace
}  // namespace gabarit
