#include "rules/region.h"

#include <gtest/gtest.h>

#include "tests/rules/fake_checks.h"
#include "tests/shapes.h"

namespace gabarit {
namespace {

// Three separate facets with centroids at x = 0, 10 and 20.
Model three_facets() {
  shapes::Triangles triangles;
  for (const double x : {0.0, 10.0, 20.0}) {
    triangles.push_back({Vec3d{x - 1, 0, 0}, Vec3d{x + 1, 0, 0}, Vec3d{x, 1, 0}});
  }
  return shapes::model(triangles);
}

Where beyond(double from) { return fake::where(fake::beyond, fake::number("from", from)); }

Where band(double from, double to) {
  Arguments arguments = fake::number("from", from);
  arguments.set("to", to);
  return fake::where(fake::band, arguments);
}

std::vector<Selected> selected(const Where& where) {
  const Model model = three_facets();
  return select(Scene(model, Device::cpu(1)), {}, where).facets;
}

constexpr Selected no = Selected::no, yes = Selected::yes, maybe = Selected::maybe;

TEST(Region, all_any_and_not_follow_three_valued_logic) {
  EXPECT_EQ(selected(beyond(10)), (std::vector{no, maybe, yes}));
  EXPECT_EQ(selected(fake::none_of(beyond(10))), (std::vector{yes, maybe, no}));
  EXPECT_EQ(selected(fake::all({beyond(10), beyond(5)})), (std::vector{no, maybe, yes}));
  EXPECT_EQ(selected(fake::all({beyond(10), beyond(15)})), (std::vector{no, no, yes}));
  EXPECT_EQ(selected(fake::any({beyond(10), beyond(5)})), (std::vector{no, yes, yes}));
  EXPECT_EQ(selected(fake::any({beyond(10), fake::none_of(beyond(10))})), (std::vector{yes, maybe, yes}));
  EXPECT_EQ(selected(Where{}), (std::vector{yes, yes, yes}));
}

TEST(Region, all_hands_the_height_band_to_what_stands_in_it) {
  const Interval everything;
  const auto seen = [](const Where& where) {
    selected(where);
    return std::pair(fake::band_seen.from, fake::band_seen.to);
  };
  const Where probe = fake::where(fake::probe);
  EXPECT_EQ(seen(probe), std::pair(everything.from, everything.to));
  EXPECT_EQ(seen(fake::all({probe, band(0, 50)})), std::pair(0.0, 50.0)) << "whatever the order";
  EXPECT_EQ(seen(fake::all({band(0, 50), band(20, 80), probe})), std::pair(20.0, 50.0));
  EXPECT_EQ(seen(fake::all({band(0, 50), fake::any({probe, beyond(0)})})), std::pair(0.0, 50.0));
  EXPECT_EQ(seen(fake::all({band(0, 50), fake::all({probe, band(20, 80)})})), std::pair(20.0, 50.0));
  EXPECT_EQ(seen(fake::all({fake::all({band(20, 80)}), probe})), std::pair(everything.from, everything.to));
  EXPECT_EQ(seen(fake::any({band(0, 50), probe})), std::pair(everything.from, everything.to));
  EXPECT_EQ(seen(fake::all({band(0, 50), fake::none_of(probe)})), std::pair(everything.from, everything.to));
}

TEST(Region, a_depth_survives_all_but_not_not) {
  const Model model = three_facets();
  const Scene scene(model, Device::cpu(1));
  const Where probe = fake::where(fake::probe);
  EXPECT_EQ(select(scene, {}, fake::all({beyond(5), probe})).depth.size(), 3U);
  EXPECT_TRUE(select(scene, {}, fake::none_of(probe)).depth.empty());
}

// Edges: yes for the first edge of every facet, no for the others; the facet is selected.
Region first_edges(const Scene& scene, const Setup&, const Arguments&) {
  Region region = whole_model(scene.mesh());
  region.edges.assign(region.facets.size(), {yes, no, maybe});
  return region;
}

TEST(Region, edges_follow_the_same_logic_and_fall_back_on_their_facet) {
  const Selector edges{.name = "edges",
                       .variant = "",
                       .summary = "",
                       .documentation = "",
                       .parameters = {},
                       .select = first_edges};
  const Model model = three_facets();
  const Scene scene(model, Device::cpu(1));
  const Region region = select(scene, {}, fake::all({fake::where(edges), beyond(10)}));
  EXPECT_EQ(region.edges.at(0), (std::array{no, no, no}));
  EXPECT_EQ(region.edges.at(1), (std::array{maybe, no, maybe}));
  EXPECT_EQ(region.edges.at(2), (std::array{yes, no, maybe}));
  EXPECT_EQ(select(scene, {}, fake::none_of(fake::where(edges))).edges.at(2), (std::array{no, yes, maybe}));
}

TEST(Region, describes_itself_in_words) {
  EXPECT_EQ(describe(fake::all({beyond(1), fake::none_of(fake::where(fake::probe))})),
            "it lies at the far end and not (`probe` selects it)");
  EXPECT_EQ(describe(fake::any({beyond(1), fake::all({beyond(2), beyond(3)})})),
            "it lies at the far end or (it lies at the far end and it lies at the far end)");
}

}  // namespace
}  // namespace gabarit
