#include "checks/contact_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "model/facet_normals.h"
#include "tests/block_solid.h"
#include "tests/checks/wall_fields.h"

namespace gabarit {
namespace {

using shapes::Triangles;
using Ends = std::pair<VertexId, VertexId>;

FacetSurface features_of(const TriangleMesh& mesh, Side side = Side::inside) {
  FacetSurface surface;
  surface.points = mesh.vertices;
  add_features(surface, mesh, facet_normals(mesh, Device::cpu(1)), Adjacency(mesh),
               std::vector<float>(mesh.facet_count(), 0), side);
  return surface;
}

std::set<Ends> edges_of(const FacetSurface& surface) {
  std::set<Ends> edges;
  for (const Primitive& p : surface.primitives)
    if (p.corner[0] != p.corner[1])
      edges.insert({std::min(p.corner[0], p.corner[1]), std::max(p.corner[0], p.corner[1])});
  return edges;
}

std::set<VertexId> vertices_of(const FacetSurface& surface) {
  std::set<VertexId> vertices;
  for (const Primitive& p : surface.primitives)
    if (p.corner[0] == p.corner[1]) vertices.insert(p.corner[0]);
  return vertices;
}

// Every two facets with two vertices in common: reflex where the rest of the one lies in front of the other.
std::set<Ends> reflex_by_brute_force(const TriangleMesh& mesh, Side side) {
  std::set<Ends> edges;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    for (FacetId g = 0; g < mesh.facet_count(); ++g) {
      std::vector<VertexId> common;
      VertexId apex = 0;
      for (const VertexId v : mesh.facets[g]) {
        const auto& corners = mesh.facets[f];
        if (std::find(corners.begin(), corners.end(), v) != corners.end())
          common.push_back(v);
        else
          apex = v;
      }
      if (f == g || common.size() != 2) continue;
      const Vec3d n = facet_normal(mesh, f), m = facet_normal(mesh, g);
      const double front = dot(mesh.vertices[apex] - mesh.vertices[common[0]], n);
      const bool toward = side == Side::inside ? front > 0 : front < 0;
      if (toward && dot(n, m) < std::cos(8 * std::numbers::pi / 180))
        edges.insert({std::min(common[0], common[1]), std::max(common[0], common[1])});
    }
  }
  return edges;
}

TEST(ContactFeatures, are_what_brute_force_over_all_pairs_of_facets_finds) {
  for (const TriangleMesh& mesh :
       {shapes::mesh(shapes::box({0, 0, 0}, {3, 2, 1})), shapes::mesh(l_bracket(3, 8)),
        shapes::mesh(grooved(1.5)), shapes::mesh(shapes::torus(12, 4, 16, 10)),
        shapes::mesh(shapes::revolve({{8, 0}, {10, 0}, {10, 6}, {8, 6}, {8, 0}}, 18)),
        shapes::with_facets(shapes::cup_with_a_handle(), 500)}) {
    for (const Side side : {Side::inside, Side::outside})
      EXPECT_EQ(edges_of(features_of(mesh, side)), reflex_by_brute_force(mesh, side));
  }
}

TEST(ContactFeatures, of_a_box_are_none_inside_and_its_twelve_edges_outside) {
  const TriangleMesh box = shapes::mesh(shapes::box({0, 0, 0}, {3, 2, 1}));
  EXPECT_TRUE(features_of(box).primitives.empty());
  EXPECT_EQ(edges_of(features_of(box, Side::outside)).size(), 12U);
  EXPECT_EQ(vertices_of(features_of(box, Side::outside)).size(), 8U);
}

TEST(ContactFeatures, of_a_groove_are_its_tip_with_both_ends) {
  const TriangleMesh mesh = shapes::mesh(grooved(1.5));
  const FacetSurface surface = features_of(mesh);
  ASSERT_EQ(edges_of(surface).size(), 1U);
  for (const VertexId v : vertices_of(surface)) {
    EXPECT_EQ(mesh.vertices[v].x, 20);
    EXPECT_EQ(mesh.vertices[v].y, 1.5);
  }
  EXPECT_EQ(vertices_of(surface).size(), 2U);
}

TEST(ContactFeatures, a_bend_of_under_8_degrees_is_none) {
  const auto roof = [](double degrees) {
    const double fall = 10 * std::tan(degrees / 2 * std::numbers::pi / 180);
    Triangles t{{Vec3d{-10, 0, fall}, Vec3d{0, 0, 0}, Vec3d{0, 10, 0}},
                {Vec3d{0, 0, 0}, Vec3d{10, 0, fall}, Vec3d{0, 10, 0}}};
    return shapes::mesh(t);
  };
  EXPECT_TRUE(features_of(roof(7.9)).primitives.empty());
  EXPECT_EQ(edges_of(features_of(roof(8.1))).size(), 1U);
}

TEST(ContactFeatures, the_part_of_an_edge_that_two_facets_share_counts_alone) {
  // A rib root whose base is one long facet on either side and whose rib is of shorter ones.
  const Triangles t{{Vec3d{0, 0, 0}, Vec3d{12, 0, 0}, Vec3d{6, -5, 0}},
                    {Vec3d{6, 0, 0}, Vec3d{0, 0, 0}, Vec3d{3, 0, 5}}};
  const TriangleMesh mesh = shapes::mesh(t);
  const FacetSurface surface = features_of(mesh);
  for (const Primitive& p : surface.primitives) {
    for (const std::size_t k : {0U, 1U}) {
      const Vec3d at = surface.points[p.corner[k]];
      EXPECT_LE(at.x, 6 + 1e-6);
      EXPECT_EQ(at.y, 0);
    }
  }
}

TEST(ContactFeatures, every_direction_of_a_fan_lets_a_ball_from_the_other_side_touch) {
  const TriangleMesh mesh =
      shapes::mesh(shapes::revolve({{8, 0}, {10, 0}, {10, 6}, {8, 6}, {8, 3}, {8, 0}}, 18));
  const FacetSurface surface = features_of(mesh);
  std::size_t inner = 0;
  for (const Primitive& p : surface.primitives) {
    const Vec3d at = (surface.points[p.corner[0]] + surface.points[p.corner[1]]) / 2.0;
    if (at.z == 0 || at.z == 6) continue;  // where the bore ends no ball can
    ++inner;
    const Vec3d outward = -normalized(Vec3d{at.x, at.y, 0});  // of the part: into the bore
    for (std::uint32_t i = surface.fan_first[p.corner[2]]; i < surface.fan_first[p.corner[2] + 1]; ++i) {
      const Vec3f w = surface.fan_directions[i];
      EXPECT_GT(static_cast<double>(w.x) * outward.x + static_cast<double>(w.y) * outward.y, -1e-6);
    }
  }
  EXPECT_EQ(inner, 3U * 18) << "two edges and a vertex for every corner of the bore";
}

TEST(ContactFeatures, moved_turned_and_permuted_there_are_as_many) {
  const Triangles shape = shapes::torus(12, 4, 16, 10);
  const std::size_t as_is = edges_of(features_of(shapes::mesh(shape))).size();
  EXPECT_GT(as_is, 0U);
  EXPECT_EQ(edges_of(features_of(shapes::mesh(shapes::permuted(shape, 4)))).size(), as_is);
  const auto turned = shapes::moved(shapes::rotated(shape, normalized(Vec3d{1, 2, 3}), 1), {500, 0, -90});
  EXPECT_EQ(edges_of(features_of(shapes::mesh(turned))).size(), as_is);
}

}  // namespace
}  // namespace gabarit
