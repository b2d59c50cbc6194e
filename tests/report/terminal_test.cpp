#include "report/terminal.h"

#include <gmock/gmock.h>

#include "report/number_text.h"
#include "tests/report/sample_report.h"

namespace gabarit {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(terminal_report, puts_what_needs_attention_first_and_the_totals_last) {
  const std::string text = terminal_report(SampleReport().report());
  std::size_t last = 0;
  for (const char* const id : {"failing  Title", "broken  Title", "undecided  Title", "passing  Title",
                               "absent  Title", "5 rules planned"}) {
    const std::size_t place = text.find(id);
    ASSERT_NE(place, std::string::npos) << id;
    EXPECT_GT(place, last) << id;
    last = place;
  }
  EXPECT_THAT(
      text,
      HasSubstr("5 rules planned: 1 failed, 1 not run, 1 undecided, 1 passed, 1 not applicable, 0 waived\n"));
}

TEST(terminal_report, never_names_a_verdict_without_what_was_examined) {
  const std::string text = terminal_report(SampleReport().report());
  EXPECT_THAT(text, HasSubstr("2 failed, of 3 facets, 600 mm² examined"));
  EXPECT_THAT(text,
              HasSubstr("worst: radius 2.25 mm (2 to 2.5), required: at least 4 mm, at (1.0, 2.0, 3.0)"));
  EXPECT_THAT(text, HasSubstr("worst: radius unknown (3 to unlimited)"));
}

TEST(terminal_report, lists_ten_findings_and_says_how_many_there_are) {
  SampleReport sample;
  auto& findings = sample.rule("failing").findings;
  findings.resize(12, findings[0]);
  for (std::size_t i = 0; i < findings.size(); ++i) findings[i].id = "failing/" + std::to_string(i + 1);
  const std::string text = terminal_report(sample.report());
  EXPECT_THAT(text, HasSubstr("failing/10 "));
  EXPECT_THAT(text, Not(HasSubstr("failing/11 ")));
  EXPECT_THAT(text, HasSubstr("… 12 in all"));
}

TEST(terminal_report, a_finding_names_the_body_and_the_exact_face_of_its_worst_facet) {
  SampleReport sample;
  sample.add_exact_faces();
  EXPECT_THAT(terminal_report(sample.report()),
              HasSubstr("2 facets, 12.5 mm², body body, face 1 'Deckfläche', a plane\n"));
  sample.model.brep->labels[1].name.clear();
  sample.model.brep->surfaces[0].kind = SurfaceKind::extrusion;
  EXPECT_THAT(terminal_report(sample.report()), HasSubstr("body body, face 1, an extrusion\n"));
}

TEST(terminal_report, colours_only_when_asked) {
  EXPECT_THAT(terminal_report(SampleReport().report()), Not(HasSubstr("\033")));
  EXPECT_THAT(terminal_report(SampleReport().report(), {.colour = true}), HasSubstr("\033[1;31mFAIL"));
}

TEST(terminal_report, names_cannot_steer_the_terminal) {
  SampleReport sample;
  sample.model.file = "a\033[2Jb\xC2\x9B.stl";
  sample.rule("failing").rule.title = "x\ny\rz";
  const std::string text = terminal_report(sample.report());
  EXPECT_THAT(text, Not(HasSubstr("\033")));
  EXPECT_THAT(text, HasSubstr("a?[2Jb??.stl"));
  EXPECT_THAT(text, HasSubstr("x?y?z"));
}

TEST(number_text, never_contradicts_the_comparison_with_the_limit) {
  EXPECT_EQ(number_text(0.79996, 0.8), "0.79996");
  EXPECT_EQ(number_text(0.8, 0.8), "0.8");
  EXPECT_EQ(number_text(2.123456, 4), "2.123");
  EXPECT_EQ(number_text(std::nextafter(4.0, 0.0), 4), "3.9999999999999996");
}

}  // namespace
}  // namespace gabarit
