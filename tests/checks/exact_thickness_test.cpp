#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "checks/clear_cells.h"
#include "tests/checks/wall_fields.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

using step_shapes::loaded;

class ExactThickness : public step_shapes::StepFiles {
 protected:
  Model tube_with_wall(double outer, double inner, double sag = 0.05) const {
    LoadOptions options;
    options.sag = sag;
    return loaded(step(step_shapes::tube(outer, inner, 30)), options);
  }
};

// As a rule "at least `limit`" has it measured; 0: no rule.
Field walls_of(const Model& model, double limit, int threads = 1, const Measure& of = thickness_measure) {
  Wanted wanted = at_least(limit, *model.sag);
  wanted.device = Device::cpu(threads);
  return measure(of, model, wanted);
}

TEST_F(ExactThickness, a_wall_of_just_the_limit_passes_and_a_thousandth_less_fails) {
  const auto worst = [&](const Model& model) {
    const Field field = walls_of(model, 1.2);
    return std::pair{*std::min_element(field.lower.begin(), field.lower.end()),
                     *std::min_element(field.upper.begin(), field.upper.end())};
  };
  EXPECT_GE(worst(tube_with_wall(10, 8.8)).first, 1.2);
  EXPECT_LT(worst(tube_with_wall(10, 8.801)).second, 1.2);
}

TEST_F(ExactThickness, the_thinnest_place_is_found_between_the_places_looked_at) {
  LoadOptions coarse;
  coarse.sag = 0.3;
  const Model model =
      loaded(step(step_shapes::minus(step_shapes::cylinder(10, 60),
                                     step_shapes::moved(step_shapes::cylinder(6, 60), 2, 0, 0))),
             coarse);
  for (const double limit : {0.0, 1.2, 2.5}) {
    const Field field = walls_of(model, limit);
    const auto thinnest = std::min_element(field.value.begin(), field.value.end()) - field.value.begin();
    const auto i = static_cast<std::size_t>(thinnest);
    EXPECT_NEAR(field.value[i], 2, 1e-4);
    EXPECT_NEAR(std::abs(field.at[i].y), 0, 0.05) << "where the walls are nearest";
    EXPECT_NEAR(length(field.at[i] - field.contact[i]), 2, 1e-3);
  }
}

TEST_F(ExactThickness, facets_of_the_same_part_agree_wherever_their_bounds_decide) {
  for (const TopoDS_Shape& shape :
       {step_shapes::tube(10, 8.5, 30), step_shapes::rounded_box(40, 30, 6, 2),
        step_shapes::minus(step_shapes::box(40, 40, 5),
                           step_shapes::moved(step_shapes::cylinder(8, 20), 20, 11, -5))}) {
    LoadOptions coarse;
    coarse.sag = 0.2;
    const Model exact = loaded(step(shape), coarse);
    Model facets = exact;
    facets.brep.reset();
    for (const double limit : {1.6, 5.5}) {
      const Field a = walls_of(exact, limit), b = walls_of(facets, limit);
      ASSERT_EQ(a.facets, b.facets);
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_FALSE(b.lower[i] >= limit && a.upper[i] < limit * (1 - 1e-9))
            << limit << " facet " << a.facets[i];
        EXPECT_FALSE(b.upper[i] < limit && a.lower[i] >= limit) << limit << " facet " << a.facets[i];
      }
    }
  }
}

// The plate is clear of the limit wherever it is looked at coarsely: its least value is found all the same.
TEST_F(ExactThickness, a_narrow_groove_in_a_plate_that_is_clear_of_the_limit_is_measured) {
  const TopoDS_Shape plate = step_shapes::minus(
      step_shapes::box(90, 70, 10), step_shapes::moved(step_shapes::box(1, 200, 7), 38.3, -50, 3));
  const Field field = walls_of(loaded(step(plate)), 1.2);
  EXPECT_NEAR(least_value(field), 3, 1e-6);
  EXPECT_GE(*std::min_element(field.lower.begin(), field.lower.end()), 1.2);
}

// The slanted side turns away from the bottom by 118 degrees: it does not count, but a surface behind such a
// facet may.
TEST_F(ExactThickness, a_cell_is_clear_only_when_no_normal_within_its_error_counts) {
  const double height = 40 * std::tan(62 * std::numbers::pi / 180);
  const Model model = loaded(step(step_shapes::prism({{0, 0}, {40, 0}, {40, height}}, 500)));
  const Scene scene(model, Device::cpu(1));
  const ContactSurface& surface = scene.surface({.side = Side::inside, .crease = 0.7, .sag = *model.sag});
  CellQuery query;
  query.point = {4, 0, 250}, query.direction = query.across = {0, 1, 0}, query.spacing = 1;
  while (facet_normal(model.mesh, query.facet).y > -0.99) ++query.facet;
  const BallOptions balls;
  for (const double error : {0.0, 0.1}) {
    std::vector<CellAnswer> answer(1);
    with_clear_cells(ball_probe(surface, balls), surface, balls,
                     {.limit = 8, .step = 0.5, .normal_error = error})({&query, 1}, answer);
    EXPECT_EQ(answer[0].clear, error == 0) << "read " << answer[0].value;
  }
}

TEST_F(ExactThickness, it_moves_with_the_part_and_does_not_depend_on_the_threads) {
  const TopoDS_Shape shape = step_shapes::minus(step_shapes::cylinder(10, 30),
                                                step_shapes::moved(step_shapes::cylinder(6, 30), 2, 0, 0));
  LoadOptions coarse;
  coarse.sag = 0.3;
  const Model model = loaded(step(shape), coarse);
  const Field here = walls_of(model, 2.5), two = walls_of(model, 2.5, 2);
  EXPECT_EQ(here.value, two.value);
  EXPECT_EQ(here.lower, two.lower);
  EXPECT_EQ(here.upper, two.upper);
  const Field there =
      walls_of(loaded(step(step_shapes::moved(step_shapes::turned(shape, 33), 900, -700, 80)), coarse), 2.5);
  EXPECT_NEAR(least_value(here), 2, 1e-4);
  EXPECT_NEAR(least_value(there), 2, 1e-4);
}

TEST_F(ExactThickness, the_gap_between_two_bodies_is_measured_the_same_way) {
  const TopoDS_Shape two = step_shapes::together(
      {step_shapes::cylinder(10, 30),
       step_shapes::minus(step_shapes::cylinder(20, 30), step_shapes::cylinder(13, 30))});
  const Field field = walls_of(loaded(step(two)), 2.5, 1, clearance_measure);
  EXPECT_EQ(*std::min_element(field.value.begin(), field.value.end()), 3);
  EXPECT_GE(*std::min_element(field.lower.begin(), field.lower.end()), 2.5);
}

}  // namespace
}  // namespace gabarit
