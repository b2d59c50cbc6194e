// The pages of rules about walls.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/report/pdf_text.h"
#include "tests/report/wall_report.h"

namespace gabarit {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr Limit at_least_3{Limit::Kind::at_least, 3, 0};

std::string page_with(const std::vector<std::string>& pages, const std::string& text) {
  for (const std::string& page : pages)
    if (page.find(text) != std::string::npos) return page;
  return {};
}

TEST(pdf_walls, the_distribution_has_ranges_figures_and_the_section_of_the_worst_ball) {
  const WallReport wall(shapes::gridded_box({0, 0, 0}, {40, 30, 2}, 8), at_least_3);
  EXPECT_THAT(page_with(pdf_pages(wall.report()), "Distribution"),
              AllOf(HasSubstr("1.5 to 2.25 2400 89.6 % beyond"), HasSubstr("Least 2 mm"),
                    HasSubstr("Critical area, by value 2400 mm² (89.6 %)"), HasSubstr("Ø 2 mm"),
                    HasSubstr("limit Ø 3 mm"), HasSubstr("Section through O and C")));
}

TEST(pdf_walls, a_finding_shows_the_section_of_its_own_ball) {
  const WallReport wall(shapes::gridded_box({0, 0, 0}, {40, 30, 2}, 8), at_least_3);
  EXPECT_THAT(page_with(pdf_pages(wall.report()), "Finding wall/1 Finding wall/1"),
              AllOf(HasSubstr("Ø 2 mm"), HasSubstr("limit Ø 3 mm"), Not(HasSubstr("Open section"))));
}

TEST(pdf_walls, a_rule_that_is_passed_shows_its_worst_ball_too) {
  const WallReport wall(shapes::gridded_box({0, 0, 0}, {40, 30, 2}, 8), {Limit::Kind::at_least, 1.5, 0});
  EXPECT_THAT(page_with(pdf_pages(wall.report()), "Distribution"),
              AllOf(HasSubstr("Ø 2 mm"), HasSubstr("limit Ø 1.5 mm")));
}

TEST(pdf_walls, the_section_of_an_open_mesh_is_an_outline) {
  auto plate = shapes::gridded_box({0, 0, 0}, {40, 30, 2}, 8);
  std::erase_if(plate,
                [](const shapes::Triangle& t) { return t[0].y == 30 && t[1].y == 30 && t[2].y == 30; });
  EXPECT_THAT(page_with(pdf_pages(WallReport(plate, at_least_3).report()), "Distribution"),
              AllOf(HasSubstr("Ø 2 mm"), HasSubstr("Open section through O and C")));
}

TEST(pdf_walls, a_ray_has_a_length_and_no_ball) {
  const WallReport wall(shapes::gridded_box({0, 0, 0}, {40, 30, 2}, 8), at_least_3, "thickness", "ray");
  EXPECT_THAT(page_with(pdf_pages(wall.report()), "Distribution"),
              AllOf(HasSubstr("Section through O and C"), HasSubstr("limit 3 mm"), Not(HasSubstr("Ø"))));
}

TEST(pdf_walls, the_colours_of_the_paper_are_an_option_and_change_pictures_alone) {
  const WallReport wall(shapes::gridded_box({0, 0, 0}, {40, 30, 2}, 8), at_least_3);
  PdfOptions options = quick_pdf();
  const std::string bytes = pdf_bytes(wall.report(), options);
  const std::string text = pdf_text(wall.report(), options);
  options.palette = ColourMap::red_to_blue;
  EXPECT_NE(pdf_bytes(wall.report(), options), bytes);
  EXPECT_EQ(pdf_text(wall.report(), options), text);
}

}  // namespace
}  // namespace gabarit
