#include <gmock/gmock.h>

#include "tests/cli/run_gabarit.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class InfoStep : public step_shapes::StepFiles {
 protected:
  Ending info(const std::filesystem::path& file, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"info", file.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_gabarit(arguments, {.folder = folder.string()});
  }
};

TEST_F(InfoStep, says_unit_bodies_faces_by_type_edges_tolerance_and_validity) {
  const Ending run = info(step(step_shapes::tube(25.4, 12.7, 50.8), "INCH"));
  EXPECT_EQ(run.exit, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, AllOf(HasSubstr("unit         in (declared)\n"), HasSubstr("bodies       1\n"),
                             HasSubstr("faces        4: 2 plane, 2 cylinder\n"),
                             HasSubstr("edges        6: 2 smooth, 4 convex\n"),
                             HasSubstr("tolerance    1e-07 mm at most\n"), HasSubstr("valid        yes\n"),
                             HasSubstr("watertight   yes\n"), Not(HasSubstr("colours")),
                             Not(HasSubstr("face names"))));
}

TEST_F(InfoStep, counts_names_and_colours_of_faces) {
  EXPECT_THAT(info(painted_iges(step_shapes::box(10, 20, 30))).out,
              HasSubstr("colours      2: #FF0000 on 3 faces, #FF8000 on 3 faces\n"));
  const std::string content = step_shapes::text_of(step(step_shapes::box(10, 20, 30)));
  const auto named =
      text("named.step", step_shapes::replaced(content, "ADVANCED_FACE(''", {"ADVANCED_FACE('top'"}));
  EXPECT_THAT(info(named).out, HasSubstr("face names   1 of 6\n"));
}

TEST_F(InfoStep, a_facet_size_makes_more_facets_of_the_same_faces) {
  const auto file = step(step_shapes::box(10, 20, 30));
  EXPECT_THAT(info(file).out, HasSubstr("facets       12\n"));
  const Ending fine = info(file, {"--facet-size", "5 mm"});
  EXPECT_EQ(fine.exit, 0);
  EXPECT_THAT(fine.out, AllOf(Not(HasSubstr("facets       12\n")), HasSubstr("faces        6: 6 plane\n")));
}

}  // namespace
}  // namespace gabarit
