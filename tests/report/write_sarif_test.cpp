#include "report/write_sarif.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/report/sample_report.h"

namespace gabarit {
namespace {

using Json = nlohmann::json;

Json sarif_run(const SampleReport& sample) { return Json::parse(sarif_json(sample.report()))["runs"][0]; }

Json result_of(const Json& run, const std::string& rule) {
  for (const Json& result : run["results"]) {
    if (result["ruleId"] == rule) return result;
  }
  return {};
}

TEST(sarif_json, is_of_version_2_1_0_and_lists_every_rule) {
  const SampleReport sample;
  EXPECT_EQ(Json::parse(sarif_json(sample.report()))["version"], "2.1.0");
  const Json run = sarif_run(sample);
  ASSERT_EQ(run["tool"]["driver"]["rules"].size(), 5U);
  for (const Json& result : run["results"]) {
    EXPECT_EQ(run["tool"]["driver"]["rules"][result["ruleIndex"].get<std::size_t>()]["id"], result["ruleId"]);
  }
}

TEST(sarif_json, gives_every_verdict_its_kind_and_level) {
  const Json run = sarif_run(SampleReport());
  const auto kind_and_level = [&](const std::string& rule) {
    const Json result = result_of(run, rule);
    return result["kind"].get<std::string>() + " " + result["level"].get<std::string>();
  };
  EXPECT_EQ(kind_and_level("passing"), "pass none");
  EXPECT_EQ(kind_and_level("failing"), "fail error");
  EXPECT_EQ(kind_and_level("undecided"), "open none");
  EXPECT_EQ(kind_and_level("absent"), "notApplicable none");
  EXPECT_EQ(kind_and_level("broken"), "open none");
}

TEST(sarif_json, a_rule_that_was_not_run_makes_the_invocation_unsuccessful) {
  SampleReport sample;
  const Json invocation = sarif_run(sample)["invocations"][0];
  EXPECT_EQ(invocation["executionSuccessful"], false);
  EXPECT_EQ(invocation["toolExecutionNotifications"][0]["associatedRule"]["id"], "broken");
  sample.outcome.results.pop_back();
  sample.outcome.totals.not_run = 0;
  EXPECT_EQ(sarif_run(sample)["invocations"][0]["executionSuccessful"], true);
}

TEST(sarif_json, a_failing_rule_without_listed_findings_still_fails) {
  SampleReport sample;
  sample.rule("failing").findings.clear();
  EXPECT_EQ(result_of(sarif_run(sample), "failing")["kind"], "fail");
}

TEST(sarif_json, the_print_of_a_finding_stays_when_it_moves_a_little) {
  SampleReport sample;
  const auto print = [&] {
    return result_of(sarif_run(sample), "failing")["partialFingerprints"]["gabaritPlace/v1"]
        .get<std::string>();
  };
  const std::string before = print();
  sample.rule("failing").findings[0].centroid.x += 0.01;
  EXPECT_EQ(print(), before);
  sample.rule("failing").findings[0].centroid.x += 100;
  EXPECT_NE(print(), before);
}

TEST(sarif_json, a_finding_on_exact_surfaces_has_its_body_and_its_face_as_logical_locations) {
  SampleReport sample;
  EXPECT_FALSE(result_of(sarif_run(sample), "failing")["locations"][0].contains("logicalLocations"));
  sample.add_exact_faces();
  const Json names = result_of(sarif_run(sample), "failing")["locations"][0]["logicalLocations"];
  ASSERT_EQ(names.size(), 2U);
  EXPECT_EQ(names[0]["name"], "body");
  EXPECT_EQ(names[1]["name"], "face 1 'Deckfläche', a plane");
}

TEST(sarif_json, says_how_many_results_are_left_out) {
  SampleReport sample;
  auto& findings = sample.rule("failing").findings;
  findings.resize(25010, findings[0]);
  const Json run = sarif_run(sample);
  EXPECT_EQ(run["results"].size(), 25000U);
  const std::string last = run["invocations"][0]["toolExecutionNotifications"].back()["message"]["text"];
  EXPECT_THAT(last, testing::HasSubstr("14 results are left out"));
}

}  // namespace
}  // namespace gabarit
