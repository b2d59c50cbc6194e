#include "checks/height.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/shapes.h"

namespace gabarit {
namespace {

constexpr Selected no = Selected::no, yes = Selected::yes;

Arguments band(double from, double to) {
  Arguments arguments;
  arguments.set("from", from);
  arguments.set("to", to);
  return arguments;
}

Region select(const Model& model, const Arguments& arguments, const Setup& setup = {}) {
  return height_selector.select(Scene(model, Device::cpu(1)), setup, arguments);
}

// One facet with corners at heights 0, 0 and 10.
Model facet() { return shapes::model({{Vec3d{0, 0, 0}, Vec3d{10, 0, 0}, Vec3d{0, 0, 10}}}); }

TEST(Height, a_facet_is_selected_when_any_part_of_it_lies_inside) {
  EXPECT_EQ(select(facet(), band(4, 5)).facets[0], yes);
  EXPECT_EQ(select(facet(), band(-5, -1)).facets[0], no);
  EXPECT_EQ(select(facet(), band(11, 20)).facets[0], no);
  EXPECT_EQ(select(facet(), band(10, 20)).facets[0], yes) << "the ends belong to the band";
  EXPECT_EQ(select(facet(), band(std::nextafter(10.0, 11.0), 20)).facets[0], no);
}

TEST(Height, edges_count_by_themselves) {
  const auto edges = select(facet(), band(4, 5)).edges.at(0);
  EXPECT_EQ(edges, (std::array{no, yes, yes})) << "the first edge lies on the ground";
}

TEST(Height, counts_along_up_from_the_ground) {
  gabarit::Setup setup;
  setup.frame.up = {0, 0, -1};
  setup.frame.ground = -10;
  EXPECT_EQ(select(facet(), band(0, 1), setup).facets[0], yes) << "the upper corner stands on the ground";
  EXPECT_EQ(select(facet(), band(10.5, 20), setup).facets[0], no);
}

TEST(Height, a_missing_end_is_open) {
  Arguments from;
  from.set("from", 5.0);
  EXPECT_EQ(select(facet(), from).facets[0], yes);
  EXPECT_DOUBLE_EQ(height_selector.height_band(from).from, 5.0);
  EXPECT_TRUE(std::isinf(height_selector.height_band(from).to));
  EXPECT_EQ(height_selector.sentence(from), "it reaches above 5 mm above ground");
}

TEST(Height, moving_model_and_ground_together_changes_nothing) {
  const auto box = shapes::gridded_box({0, 0, 0}, {8, 8, 8}, 1);
  const Region as_is = select(shapes::model(box), band(2, 3));
  gabarit::Setup setup;
  setup.frame.ground = 64;
  EXPECT_EQ(select(shapes::model(shapes::moved(box, {16, 32, 64})), band(2, 3), setup).facets, as_is.facets);
  std::vector<std::uint32_t> order;
  const Region permuted = select(shapes::model(shapes::permuted(box, 3, &order)), band(2, 3));
  for (std::size_t f = 0; f < order.size(); ++f) EXPECT_EQ(permuted.facets[f], as_is.facets[order[f]]);
}

TEST(Height, a_facet_that_is_nowhere_is_only_maybe_selected) {
  Model model = facet();
  model.mesh.vertices[model.mesh.facets[0][2]].z = NAN;
  EXPECT_EQ(select(model, band(4, 5)).facets[0], Selected::maybe);
}

}  // namespace
}  // namespace gabarit
