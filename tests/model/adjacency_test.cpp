#include "model/adjacency.h"

#include <algorithm>
#include <numbers>
#include <random>
#include <tuple>

#include <gmock/gmock.h>

#include "tests/shapes.h"

namespace gabarit {
namespace {

using shapes::Triangle;
using shapes::Triangles;

struct Shared {
  FacetId facet, other;
  int edge, other_edge;
  bool reversed;
  double from, to;
};

bool operator<(const Shared& a, const Shared& b) {
  return std::tie(a.facet, a.edge, a.other, a.other_edge, a.from) <
         std::tie(b.facet, b.edge, b.other, b.other_edge, b.from);
}

std::vector<Shared> shared_edges(const TriangleMesh& mesh, std::span<const FacetId> of = {}) {
  const Adjacency adjacency(mesh, of);
  std::vector<Shared> found;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    for (const EdgeNeighbour& n : adjacency.of(f))
      found.push_back({f, n.facet, n.edge, n.other, n.reversed, n.from, n.to});
  }
  return found;
}

struct Edge {
  FacetId facet;
  int number;
  Vec3d from, to;
};

std::vector<Edge> edges_of(const TriangleMesh& mesh) {
  std::vector<Edge> edges;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    if (facet_normal(mesh, f) == Vec3d{}) continue;
    for (int e = 0; e < 3; ++e) edges.push_back({f, e, mesh.corner(f, e), mesh.corner(f, (e + 1) % 3)});
  }
  return edges;
}

bool same_ends(const Edge& a, const Edge& b) {
  return (a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from);
}

// Every pair of edges against the definition. Made for points on a grid: collinear edges are so exactly.
std::vector<Shared> by_definition(const TriangleMesh& mesh) {
  const std::vector<Edge> edges = edges_of(mesh);
  std::vector<bool> open(edges.size(), true);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t k = 0; k < edges.size(); ++k) {
      if (i != k && same_ends(edges[i], edges[k])) open[i] = false;
    }
  }
  std::vector<Shared> found;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const Edge& a = edges[i];
      const Edge& b = edges[k];
      if (a.facet == b.facet) continue;
      if (same_ends(a, b)) {
        found.push_back({a.facet, b.facet, a.number, b.number, a.from == b.to, 0, 1});
      } else if (open[i] && open[k]) {
        const Vec3d u = a.to - a.from;
        if (length(cross(u, b.from - a.from)) > 1e-9 || length(cross(u, b.to - a.from)) > 1e-9) continue;
        const double begin = dot(b.from - a.from, u) / squared_length(u);
        const double end = dot(b.to - a.from, u) / squared_length(u);
        const double from = std::max(0.0, std::min(begin, end));
        const double to = std::min(1.0, std::max(begin, end));
        if ((to - from) * length(u) > 1e-3)
          found.push_back({a.facet, b.facet, a.number, b.number, end < begin, from, to});
      }
    }
  }
  return found;
}

void expect_same(std::vector<Shared> found, std::vector<Shared> expected) {
  std::sort(found.begin(), found.end());
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Shared& a = found[i];
    const Shared& b = expected[i];
    ASSERT_EQ(std::tie(a.facet, a.edge, a.other, a.other_edge, a.reversed),
              std::tie(b.facet, b.edge, b.other, b.other_edge, b.reversed));
    EXPECT_NEAR(a.from, b.from, 1e-6);
    EXPECT_NEAR(a.to, b.to, 1e-6);
  }
}

Triangles grid_soup(std::uint32_t seed, int facets) {
  std::mt19937 random(seed);
  const auto point = [&] {
    return Vec3d{static_cast<double>(random() % 5), static_cast<double>(random() % 4),
                 static_cast<double>(random() % 2)};
  };
  Triangles triangles;
  for (int i = 0; i < facets; ++i) triangles.push_back({point(), point(), point()});
  return triangles;
}

// A wall of two facets above a floor line that the row below meets with four: T-junctions along z = 0.
Triangles wall_on_four() {
  Triangles out{{{{0, 0, 0}, {8, 0, 0}, {8, 0, 5}}}, {{{0, 0, 0}, {8, 0, 5}, {0, 0, 5}}}};
  for (int i = 0; i < 4; ++i) out.push_back({{{2.0 * i + 2, 0, 0}, {2.0 * i, 0, 0}, {2.0 * i, 0, -3}}});
  return out;
}

TEST(adjacency, of_a_closed_box_gives_every_facet_three_neighbours_that_run_the_other_way) {
  const TriangleMesh mesh = shapes::mesh(shapes::gridded_box({0, 0, 0}, {3, 2, 1}, 1));
  const Adjacency adjacency(mesh);
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const auto neighbours = adjacency.of(f);
    ASSERT_EQ(neighbours.size(), 3U);
    for (std::uint8_t e = 0; e < 3; ++e) {
      EXPECT_EQ(neighbours[e].edge, e);
      EXPECT_TRUE(neighbours[e].reversed);
      EXPECT_EQ(neighbours[e].from, 0);
      EXPECT_EQ(neighbours[e].to, 1);
    }
  }
}

TEST(adjacency, finds_the_four_edges_that_a_long_one_is_shared_with) {
  const TriangleMesh mesh = shapes::mesh(wall_on_four());
  const Adjacency adjacency(mesh);
  const auto neighbours = adjacency.of(0);
  ASSERT_EQ(neighbours.size(), 5U);  // four below and the other half of the wall
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(neighbours[i].facet, 2 + i);
    EXPECT_EQ(neighbours[i].edge, 0);
    EXPECT_TRUE(neighbours[i].reversed);
    EXPECT_FLOAT_EQ(neighbours[i].from, 0.25F * static_cast<float>(i));
    EXPECT_FLOAT_EQ(neighbours[i].to, 0.25F * static_cast<float>(i + 1));
  }
  const auto below = adjacency.of(3);
  ASSERT_EQ(below.size(), 1U);
  EXPECT_EQ(below[0].facet, 0U);
  EXPECT_EQ(below[0].from, 0);
  EXPECT_EQ(below[0].to, 1);
}

TEST(adjacency, joins_edges_a_little_apart_and_no_further) {
  for (const auto& [gap, joined] : {std::pair{0.0009, true}, std::pair{0.0011, false}}) {
    Triangles two{{{{0, 0, 0}, {8, 0, 0}, {4, 5, 0}}}, {{{9, -gap, 0}, {-1, -gap, 0}, {4, -5, 0}}}};
    EXPECT_EQ(Adjacency(shapes::mesh(two)).of(0).size(), joined ? 1U : 0U) << gap;
    EXPECT_EQ(Adjacency(shapes::mesh(two)).of(1).size(), joined ? 1U : 0U) << gap;
  }
}

TEST(adjacency, edges_that_only_touch_at_a_point_or_cross_are_not_shared) {
  EXPECT_TRUE(
      shared_edges(shapes::mesh({{{{0, 0, 0}, {4, 0, 0}, {2, 3, 0}}}, {{{4, 0, 0}, {8, 0, 0}, {6, 3, 0}}}}))
          .empty());
  EXPECT_TRUE(
      shared_edges(shapes::mesh({{{{0, 0, 0}, {4, 0, 0}, {2, 3, 0}}}, {{{2, -1, 0}, {2, 1, 0}, {9, 0, 3}}}}))
          .empty());
}

TEST(adjacency, a_closed_edge_of_another_body_that_lies_there_is_no_neighbour) {
  const Triangles two = shapes::joined(wall_on_four(), shapes::box({-1, -1, 0}, {9, 0, 1}));
  const TriangleMesh mesh = shapes::mesh(two);
  const Adjacency adjacency(mesh);
  EXPECT_EQ(adjacency.of(0).size(), 5U);
  for (const EdgeNeighbour& n : adjacency.of(0)) EXPECT_LT(n.facet, 6U);
}

TEST(adjacency, duplicates_and_three_facets_on_an_edge_are_all_told) {
  const Triangle t{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const TriangleMesh mesh = shapes::mesh({t, t, {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}}});
  const Adjacency adjacency(mesh);
  EXPECT_EQ(adjacency.of(0).size(), 4U);
  EXPECT_EQ(adjacency.of(2).size(), 2U);
  for (const EdgeNeighbour& n : adjacency.of(0)) EXPECT_FALSE(n.reversed);
}

TEST(adjacency, degenerate_and_non_finite_facets_have_no_neighbours) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const TriangleMesh mesh = shapes::mesh({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                          {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}},
                                          {{{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}}});
  EXPECT_TRUE(shared_edges(mesh).empty());
}

TEST(adjacency, agrees_with_every_pair_of_edges_on_random_triangles) {
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    const TriangleMesh mesh = shapes::mesh(grid_soup(seed, 5 + static_cast<int>(seed)));
    expect_same(shared_edges(mesh), by_definition(mesh));
  }
}

TEST(adjacency, of_some_facets_is_the_same_as_theirs_in_the_whole) {
  const TriangleMesh mesh = shapes::mesh(grid_soup(99, 60));
  const std::vector<Shared> all = shared_edges(mesh);
  const std::vector<FacetId> some{7, 3, 3, 41, 59};
  std::vector<Shared> expected;
  for (const Shared& one : all) {
    if (std::find(some.begin(), some.end(), one.facet) != some.end()) expected.push_back(one);
  }
  expect_same(shared_edges(mesh, some), expected);
  EXPECT_TRUE(Adjacency(mesh, some).of(0).empty());
}

TEST(adjacency, does_not_depend_on_place_direction_or_order) {
  const Triangles triangles = shapes::joined(grid_soup(7, 40), shapes::moved(wall_on_four(), {20, 0, 0}));
  const std::vector<Shared> expected = shared_edges(shapes::mesh(triangles));
  expect_same(shared_edges(shapes::mesh(shapes::moved(triangles, {1000, -2000, 500}))), expected);
  const Vec3d axis = normalized(Vec3d{1, 2, 3});
  expect_same(shared_edges(shapes::mesh(shapes::rotated(triangles, axis, 0.7))), expected);
  // Facets in another order, the first corners where they were.
  std::vector<FacetId> order(triangles.size());
  for (FacetId f = 0; f < order.size(); ++f) order[f] = f;
  std::shuffle(order.begin(), order.end(), std::mt19937(4));
  Triangles shuffled;
  for (const FacetId f : order) shuffled.push_back(triangles[f]);
  std::vector<Shared> found = shared_edges(shapes::mesh(shuffled));
  for (Shared& one : found) one.facet = order[one.facet], one.other = order[one.other];
  expect_same(found, expected);
}

}  // namespace
}  // namespace gabarit
