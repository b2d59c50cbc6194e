#include "model/defects.h"

#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "tests/shapes.h"

namespace gabarit {
namespace {

const shapes::Triangles box = shapes::gridded_box({0, 0, 0}, {3, 2, 1}, 1);

Defects defects_of(const shapes::Triangles& triangles) { return count_defects(shapes::mesh(triangles)); }

TEST(defects, a_closed_box_has_none) {
  EXPECT_EQ(defects_of(box), Defects{});
  EXPECT_TRUE(watertight(defects_of(box)));
}

TEST(defects, a_missing_facet_opens_three_edges) {
  shapes::Triangles open = box;
  open.erase(open.begin() + 5);
  EXPECT_EQ(defects_of(open), (Defects{.open_edges = 3}));
  EXPECT_FALSE(watertight(defects_of(open)));
}

TEST(defects, a_flipped_facet_has_three_misoriented_edges) {
  shapes::Triangles turned = box;
  std::swap(turned[5][0], turned[5][1]);
  EXPECT_EQ(defects_of(turned), (Defects{.misoriented_edges = 3}));
  EXPECT_FALSE(watertight(defects_of(turned)));
}

TEST(defects, a_duplicate_counts_whichever_way_its_corners_run) {
  for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{1, 2, 0}, std::array{2, 1, 0}}) {
    shapes::Triangles twice = box;
    const shapes::Triangle& t = box[7];
    twice.push_back(
        {t[static_cast<std::size_t>(a)], t[static_cast<std::size_t>(b)], t[static_cast<std::size_t>(c)]});
    EXPECT_EQ(defects_of(twice), (Defects{.duplicate = 1, .non_manifold_edges = 3}));
  }
  // Alone, and three times over.
  EXPECT_EQ(defects_of({box[0], shapes::flipped({box[0]})[0]}), (Defects{.duplicate = 1}));
  EXPECT_EQ(defects_of({box[0], box[0], box[0]}), (Defects{.duplicate = 2, .non_manifold_edges = 3}));
}

TEST(defects, degenerate_and_non_finite_facets_are_counted_and_take_no_part_in_edges) {
  shapes::Triangles all = box;
  all.push_back({{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}});
  all.push_back({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}});
  all.push_back({{{0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0}}});
  all.push_back({{{0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<double>::infinity(), 0}}});
  EXPECT_EQ(defects_of(all), (Defects{.not_finite = 2, .degenerate = 2}));
}

TEST(defects, two_boxes_that_share_an_edge_are_not_manifold_there) {
  const shapes::Triangles two =
      shapes::joined(shapes::box({0, 0, 0}, {1, 1, 1}), shapes::box({1, 1, 0}, {2, 2, 1}));
  EXPECT_EQ(defects_of(two), (Defects{.non_manifold_edges = 1}));
}

// Straight from the definitions, edge by edge.
Defects by_definition(const TriangleMesh& mesh) {
  Defects defects;
  std::map<std::pair<VertexId, VertexId>, std::vector<bool>> edges;
  std::set<std::set<VertexId>> seen;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    if (facet_normal(mesh, f) == Vec3d{}) {
      ++defects.degenerate;
      continue;
    }
    const auto& v = mesh.facets[f];
    defects.duplicate += !seen.insert({v[0], v[1], v[2]}).second;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId a = v[i];
      const VertexId b = v[(i + 1) % 3];
      edges[std::minmax(a, b)].push_back(a < b);
    }
  }
  for (const auto& [ends, ways] : edges) {
    defects.open_edges += ways.size() == 1;
    defects.non_manifold_edges += ways.size() > 2;
    defects.misoriented_edges += ways.size() == 2 && ways[0] == ways[1];
  }
  return defects;
}

shapes::Triangles soup(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto point = [&] {
    return Vec3d{static_cast<double>(random() % 3), static_cast<double>(random() % 3),
                 static_cast<double>(random() % 2)};
  };
  shapes::Triangles triangles;
  for (int i = 0; i < 150; ++i) triangles.push_back({point(), point(), point()});
  return triangles;
}

TEST(defects, of_random_triangles_are_what_the_definitions_give) {
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    const TriangleMesh mesh = shapes::mesh(soup(seed));
    EXPECT_EQ(count_defects(mesh), by_definition(mesh)) << seed;
  }
}

TEST(defects, do_not_depend_on_place_or_order) {
  const shapes::Triangles triangles = soup(31);
  const Defects expected = defects_of(triangles);
  EXPECT_EQ(defects_of(shapes::permuted(triangles, 1)), expected);
  EXPECT_EQ(defects_of(shapes::moved(triangles, {1024, -512, 64})), expected);
  EXPECT_EQ(defects_of(shapes::rotated(triangles, {0, 0, 1}, std::numbers::pi / 3)).open_edges,
            expected.open_edges);
}

}  // namespace
}  // namespace gabarit
