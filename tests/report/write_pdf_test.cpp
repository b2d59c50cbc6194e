#include "report/write_pdf.h"

#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "report/write.h"
#include "rules/totals.h"
#include "tests/report/pdf_text.h"
#include "tests/report/sample_report.h"
#include "tests/shapes.h"
#include "tests/temporary_folder.h"

namespace gabarit {
namespace {

using testing::AllOf;
using testing::Each;
using testing::Gt;
using testing::HasSubstr;
using testing::Lt;
using testing::Not;

TEST(write_pdf, every_page_carries_the_report_id_and_its_number) {
  const SampleReport sample;
  const std::vector<std::string> pages = pdf_pages(sample.report());
  ASSERT_GT(pages.size(), 10U);
  for (std::size_t i = 0; i < pages.size(); ++i) {
    EXPECT_THAT(pages[i], AllOf(HasSubstr("Report " + sample.report().id),
                                HasSubstr(fmt::format("{} of {}", i + 1, pages.size()))));
  }
}

TEST(write_pdf, the_cover_identifies_the_part_the_rules_and_the_verdict) {
  const SampleReport sample;
  const std::string cover = pdf_pages(sample.report()).front();
  for (const std::string& what :
       {std::string("part.stl"), std::string(64, 'a'), std::string(64, 'b'),
        std::string("sample-rules, revision 7"), std::string("FAIL"),
        std::string("5 rules planned: 1 failed, 1 not run, 1 undecided, 1 passed, 1 not applicable")}) {
    EXPECT_THAT(cover, HasSubstr(what));
  }
}

TEST(write_pdf, the_summary_holds_every_verdict_the_number_that_decides_and_what_was_not_run) {
  const SampleReport sample;
  const std::string summary = pdf_pages(sample.report())[1];
  for (const char* const what : {"PASS", "FAIL", "UNDECIDED", "NOT APPLICABLE", "NOT RUN", "2.25 mm",
                                 "at least 4 mm", "2 of 3", "broken: It ran out of memory."}) {
    EXPECT_THAT(summary, HasSubstr(what));
  }
}

TEST(write_pdf, the_summary_stays_on_one_page_however_many_rules_there_are) {
  SampleReport sample;
  for (int i = 0; i < 3000; ++i)
    sample.outcome.results.push_back(sample_result(fmt::format("more-{}", i), Verdict::not_run));
  sample.outcome.totals = count(sample.outcome.results);
  const std::vector<std::string> pages = pdf_pages(sample.report());
  EXPECT_THAT(pages[1], AllOf(HasSubstr("3005 rules shown, those that need attention first"),
                              HasSubstr("3001 not run")));
  EXPECT_THAT(pages[2], HasSubstr("Item and set-up"));
  EXPECT_THAT(pages.back(), HasSubstr("End of report"));
  EXPECT_LT(pages.size(), 150U);
}

TEST(write_pdf, the_last_page_says_what_the_report_is_evidence_of) {
  const std::string last = pdf_pages(SampleReport().report()).back();
  for (const char* const what :
       {"End of report", "relates only to the files listed", "not a type approval", "Signature"}) {
    EXPECT_THAT(last, HasSubstr(what));
  }
}

TEST(write_pdf, a_finding_has_a_page_with_its_place_in_both_frames_and_its_stl) {
  SampleReport sample;
  sample.outcome.setups[0].frame = {{0, 0, 1}, {-1, 0, 0}, 2};
  for (const std::string& page : pdf_pages(sample.report())) {
    if (page.find("Finding failing/1") == std::string::npos || page.find("Place, model") == std::string::npos)
      continue;
    EXPECT_THAT(page, AllOf(HasSubstr("Place, model (1.0, 2.0, 3.0) mm"),
                            HasSubstr("Place, vehicle (1.0, 2.0, 1.0) mm"),
                            HasSubstr("violations/failing.stl"), HasSubstr("12.5 mm² in 2 facets")));
    return;
  }
  ADD_FAILURE() << "no page for the finding";
}

TEST(write_pdf, the_page_of_a_finding_on_exact_surfaces_names_its_body_and_its_faces) {
  SampleReport sample;
  sample.add_exact_faces();
  for (const std::string& page : pdf_pages(sample.report())) {
    if (page.find("Finding failing/1") == std::string::npos || page.find("Place, model") == std::string::npos)
      continue;
    EXPECT_THAT(page, AllOf(HasSubstr("Body body"), HasSubstr("Worst on face 1 'Deckfläche', a plane"),
                            HasSubstr("Reaches over faces 0, 1")));
    return;
  }
  ADD_FAILURE() << "no page for the finding";
}

TEST(write_pdf, the_item_page_says_where_the_sag_comes_from) {
  SampleReport sample;
  sample.model.sag.reset();
  Report report = sample.report();
  EXPECT_THAT(pdf_pages(report)[2], HasSubstr("the default: neither"));
  sample.outcome.rulesets[0].sag = 0.1;
  EXPECT_THAT(pdf_pages(report)[2], HasSubstr("0.1 mm, from the rule file"));
  report.command_line = {"gabarit", "check", "--sag", "0.1mm"};
  EXPECT_THAT(pdf_pages(report)[2], HasSubstr("0.1 mm, given on the command line"));
}

TEST(write_pdf, same_report_same_bytes_on_any_number_of_threads) {
  const SampleReport sample;
  PdfOptions options = quick_pdf();
  options.device = Device::cpu(1);
  const std::string bytes = pdf_bytes(sample.report(), options);
  EXPECT_EQ(pdf_bytes(sample.report(), options), bytes);
  options.device = Device::cpu(5);
  EXPECT_EQ(pdf_bytes(sample.report(), options), bytes);
}

TEST(write_pdf, the_date_is_that_of_the_report_or_none) {
  const SampleReport sample;
  Report report = sample.report();
  report.date = "";
  EXPECT_THAT(pdf_bytes(report), Not(HasSubstr("CreationDate")));
  report.date = "2023-11-14T22:13:20Z";
  EXPECT_THAT(pdf_bytes(report), HasSubstr("D:20231114221320Z"));
}

TEST(write_pdf, many_findings_are_listed_up_to_a_number_and_counted_in_full) {
  SampleReport sample;
  RuleResult& failing = sample.rule("failing");
  const Finding first = failing.findings.front();
  for (int i = 2; i <= 2500; ++i) {
    failing.findings.push_back(first);
    failing.findings.back().id = fmt::format("failing/{}", i);
  }
  const std::string text = pdf_text(sample.report());
  EXPECT_THAT(text, AllOf(HasSubstr("failing/1000 "), Not(HasSubstr("failing/1001 ")),
                          HasSubstr("2500 findings in all")));
  EXPECT_THAT(text, AllOf(HasSubstr("Finding failing/8 "), Not(HasSubstr("Finding failing/9 "))));
}

TEST(write_pdf, findings_of_a_note_are_listed_without_pages_of_their_own) {
  SampleReport sample;
  RuleResult& failing = sample.rule("failing");
  failing.rule.severity = Severity::note;
  const std::string text = pdf_text(sample.report());
  EXPECT_THAT(text, AllOf(HasSubstr(failing.findings.front().id + " FAIL"),
                          HasSubstr("its findings have no pages of their own"),
                          Not(HasSubstr("Finding " + failing.findings.front().id + " "))));
}

TEST(write_pdf, a_long_rule_file_is_cut_off_with_a_note) {
  SampleReport sample;
  for (int i = 0; i < 60000; ++i) sample.outcome.rulesets[0].text += fmt::format("# line {:9}\n", i);
  const std::string text = pdf_text(sample.report());
  EXPECT_THAT(text,
              AllOf(HasSubstr("# line 1198"), Not(HasSubstr("# line 1201")), HasSubstr("The file goes on")));
}

// Latin, Greek, Cyrillic, Japanese, Hebrew, emoji, controls, one word without end.
const std::string hostile = "\x1b[31m\xff\xfe Ünï Ωμέγα Привет 日本 שלום 🏍\u202e\t" +
                            std::string(5000, 'W') + " end";

void make_hostile(SampleReport& sample) {
  sample.model.file = sample.model.format = hostile;
  sample.model.bodies = std::vector<std::string>(300, hostile);
  sample.model.warnings.resize(50);
  for (Diagnostic& warning : sample.model.warnings) warning.message = hostile;
  RuleSet& set = sample.outcome.rulesets[0];
  set.title = set.file = set.revision = set.source.document = set.text = hostile;
  for (RuleResult& result : sample.outcome.results) {
    result.rule.title = result.rule.clause = result.reason = result.rule.require.limit_text = hostile;
    result.region.notes = result.field.notes = {hostile};
    for (Finding& finding : result.findings) finding.body = hostile;
  }
}

TEST(write_pdf, no_text_runs_off_the_page_whatever_it_is) {
  SampleReport sample;
  make_hostile(sample);
  Report report = sample.report();
  report.command_line = std::vector<std::string>(100, hostile);
  const std::vector<Word> words = pdf_words(report);
  ASSERT_GT(words.size(), 500U);
  constexpr double mm = 72 / 25.4, slack = 0.5;
  for (const Word& word : words) {
    EXPECT_THAT(word.left, Gt((20 - slack) * mm)) << word.text;
    EXPECT_THAT(word.right, Lt((190 + slack) * mm)) << word.text;
    EXPECT_THAT(word.bottom, Lt(288 * mm)) << word.text;
  }
}

TEST(write_pdf, numbers_without_end_and_places_nowhere_are_words) {
  SampleReport sample;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  RuleResult& failing = sample.rule("failing");
  failing.findings[0].worst.at = failing.findings[0].centroid = failing.worst.at = {nan, nan, nan};
  failing.findings[0].box = {};
  failing.worst.upper = std::numeric_limits<double>::infinity();
  const std::string text = pdf_text(sample.report());
  EXPECT_THAT(text,
              AllOf(HasSubstr("Place, model unknown"), HasSubstr("to unlimited"), Not(HasSubstr("nan"))));
}

TEST(write_pdf, a_model_of_which_nothing_is_finite_has_a_report) {
  SampleReport sample;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (Vec3d& vertex : sample.model.mesh.vertices) vertex = {nan, nan, nan};
  sample.model.box = {};
  EXPECT_THAT(pdf_text(sample.report()), HasSubstr("none: nothing is finite"));
}

TEST(write_pdf, nothing_but_rules_that_were_not_run_is_no_pass) {
  SampleReport sample;
  sample.outcome.results = {sample_result("first", Verdict::not_run),
                            sample_result("second", Verdict::not_run)};
  sample.outcome.totals = count(sample.outcome.results);
  sample.outcome.verdict = overall(sample.outcome.results);
  const std::string cover = pdf_pages(sample.report()).front();
  EXPECT_THAT(cover, AllOf(HasSubstr("NOT RUN"), HasSubstr("2 not run"), Not(HasSubstr("PASS"))));
}

TEST(write_pdf, an_outcome_without_rules_or_rule_sets_has_a_report) {
  SampleReport sample;
  sample.outcome = {};
  EXPECT_THAT(pdf_text(sample.report()), AllOf(HasSubstr("NOT RUN"), HasSubstr("0 rules planned")));
}

TEST(write, writes_the_report_among_the_outputs) {
  const TemporaryFolder folder;
  SampleReport sample;
  sample.outcome.results = {sample_result("quick", Verdict::not_run)};  // has no pictures
  WriteOptions options;
  options.formats = {Format::pdf, Format::json};
  ASSERT_TRUE(write(sample.report(), folder.path(), options).has_value());
  EXPECT_THAT(content(folder / "report.pdf"), testing::StartsWith("%PDF-1."));
}

}  // namespace
}  // namespace gabarit
