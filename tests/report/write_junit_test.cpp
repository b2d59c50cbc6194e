#include "report/write_junit.h"

#include <gmock/gmock.h>

#include "report/xml_text.h"
#include "tests/report/sample_report.h"

namespace gabarit {
namespace {

using testing::HasSubstr;

TEST(junit_xml, counts_a_rule_of_every_verdict) {
  const std::string xml = junit_xml(SampleReport().report());
  EXPECT_THAT(
      xml,
      HasSubstr(
          "<testsuites name=\"gabarit part.stl\" tests=\"5\" failures=\"1\" errors=\"2\" skipped=\"1\">"));
  EXPECT_THAT(
      xml,
      HasSubstr("<testsuite name=\"sample-rules\" tests=\"5\" failures=\"1\" errors=\"2\" skipped=\"1\">"));
}

// What stands between the opening and the closing tag of a rule's test case.
std::string test_case(const std::string& rule) {
  const std::string xml = junit_xml(SampleReport().report());
  const std::size_t from = xml.find("name=\"" + rule + ":");
  return xml.substr(from, xml.find("</testcase>", from) - from);
}

TEST(junit_xml, a_violation_is_a_failure_that_says_where) {
  EXPECT_THAT(test_case("failing"), HasSubstr("<failure type=\"fail\" message=\"2 facets fail, of 3 facets"));
  EXPECT_THAT(test_case("failing"),
              HasSubstr("failing/1: radius 2.25 mm (2 to 2.5), required: at least 4 mm, at (1.0, 2.0, 3.0)"));
}

TEST(junit_xml, a_finding_names_its_body_and_on_exact_surfaces_its_face) {
  SampleReport sample;
  EXPECT_THAT(junit_xml(sample.report()), HasSubstr(", at (1.0, 2.0, 3.0)\n"));
  sample.add_exact_faces();
  sample.rule("failing").findings[0].faces = {0, 1};
  EXPECT_THAT(junit_xml(sample.report()),
              HasSubstr(", at (1.0, 2.0, 3.0), body body, face 1 'Deckfläche', a plane; over faces 0, 1\n"));
}

TEST(junit_xml, undecided_and_not_run_never_look_like_a_pass) {
  EXPECT_THAT(test_case("undecided"), HasSubstr("<error type=\"undecided\""));
  EXPECT_THAT(test_case("broken"), HasSubstr("<error type=\"not_run\""));
  EXPECT_THAT(test_case("broken"), HasSubstr("It ran out of memory."));
}

TEST(junit_xml, a_pass_says_what_was_examined_and_a_skip_says_why) {
  EXPECT_THAT(test_case("passing"), HasSubstr("<system-out>of 2 facets, 600 mm² examined"));
  EXPECT_THAT(test_case("absent"),
              HasSubstr("<skipped message=\"of 0 facets, 0 mm² examined. No facet is selected.\"/>"));
}

TEST(xml_text, escapes_markup_and_keeps_words_of_all_scripts) {
  EXPECT_EQ(xml_text("a<b>&\"c"), "a&lt;b&gt;&amp;&quot;c");
  EXPECT_EQ(xml_text("Außenhaut обтекатель カウル 🏍"),
            "Außenhaut обтекатель カウル 🏍");
}

TEST(xml_text, replaces_what_xml_cannot_hold) {
  const std::string unknown = "\xEF\xBF\xBD";
  EXPECT_EQ(xml_text(std::string("\x01\0\x1b", 3)), unknown + unknown + unknown);
  EXPECT_EQ(xml_text("\xC3"), unknown);                              // cut off
  EXPECT_EQ(xml_text("\xC0\x80"), unknown + unknown);                // overlong
  EXPECT_EQ(xml_text("\xED\xA0\x80"), unknown + unknown + unknown);  // surrogate
  EXPECT_EQ(xml_text("\xEF\xBF\xBF"), unknown + unknown + unknown);  // no character
  EXPECT_EQ(xml_text("\xFFx"), unknown + "x");
}

}  // namespace
}  // namespace gabarit
