#include "report/write_json.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/report/sample_report.h"

namespace gabarit {
namespace {

using Json = nlohmann::ordered_json;
using testing::ElementsAre;

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) names.push_back(name);
  return names;
}

TEST(results_json, has_the_keys_of_the_contract_in_their_order) {
  const Json json = Json::parse(results_json(SampleReport().report()));
  EXPECT_THAT(keys(json),
              ElementsAre("schema", "gabarit", "verdict", "model", "rulesets", "device", "rules", "totals"));
  EXPECT_THAT(keys(json["model"]), ElementsAre("file", "sha256", "unit", "facets", "bodies", "box", "sag",
                                               "watertight", "defects"));
  EXPECT_THAT(keys(json["rulesets"][0]), ElementsAre("id", "revision", "sha256"));
  EXPECT_THAT(keys(json["rules"][1]),
              ElementsAre("id", "title", "clause", "severity", "verdict", "reason", "facets_examined",
                          "area_examined", "facets_failed", "worst", "limit", "findings", "statistics"));
  EXPECT_THAT(keys(json["rules"][1]["statistics"]),
              ElementsAre("minimum", "maximum", "mean", "critical_area", "failed_area", "undecided_area",
                          "area_without_value", "ranges"));
  EXPECT_THAT(keys(json["rules"][1]["statistics"]["ranges"][0]),
              ElementsAre("from", "to", "area", "share", "critical"));
  EXPECT_THAT(keys(json["rules"][1]["worst"]),
              ElementsAre("value", "lower", "upper", "unit", "at", "facet", "body", "face", "face_name"));
  EXPECT_THAT(keys(json["rules"][1]["findings"][0]),
              ElementsAre("id", "verdict", "facets", "area", "worst", "centroid", "box", "faces"));
  EXPECT_THAT(keys(json["totals"]),
              ElementsAre("planned", "passed", "failed", "undecided", "not_applicable", "not_run", "waived"));
  EXPECT_EQ(json["schema"], "gabarit.results/1");
}

TEST(results_json, says_what_was_found) {
  const Json json = Json::parse(results_json(SampleReport().report()));
  EXPECT_EQ(json["verdict"], "fail");
  EXPECT_EQ(json["model"]["facets"], 12);
  EXPECT_EQ(json["model"]["watertight"], true);
  EXPECT_EQ(json["model"]["box"]["max"], Json::array({10.0, 20.0, 30.0}));
  EXPECT_EQ(json["rules"][1]["worst"]["upper"], 2.5);
  EXPECT_EQ(json["rules"][1]["limit"]["at_least"], 4.0);
  EXPECT_EQ(json["rules"][4]["verdict"], "not_run");
  EXPECT_EQ(json["rules"][4]["worst"], nullptr);
  EXPECT_EQ(json["rules"][4]["statistics"], nullptr);
  EXPECT_EQ(json["rules"][1]["statistics"]["minimum"], 1.25);
  EXPECT_EQ(json["rules"][1]["statistics"]["ranges"][4]["from"], 4.0);
  EXPECT_EQ(json["rules"][1]["statistics"]["ranges"][7]["to"], 20.0);
  EXPECT_EQ(json["totals"]["planned"], 5);
  EXPECT_EQ(json["totals"]["not_run"], 1);
}

TEST(results_json, names_the_body_and_the_exact_face_of_the_worst_facet) {
  SampleReport sample;
  EXPECT_EQ(Json::parse(results_json(sample.report()))["rules"][1]["worst"]["body"], "body");
  EXPECT_EQ(Json::parse(results_json(sample.report()))["rules"][1]["worst"]["face"], nullptr);
  sample.add_exact_faces();
  const Json failing = Json::parse(results_json(sample.report()))["rules"][1];
  for (const Json& worst : {failing["worst"], failing["findings"][0]["worst"]}) {
    EXPECT_EQ(worst["body"], "body");
    EXPECT_EQ(worst["face"], 1);
    EXPECT_EQ(worst["face_name"], "Deckfläche");
  }
  EXPECT_EQ(failing["findings"][0]["faces"], Json::array({0, 1}));
  EXPECT_EQ(Json::parse(results_json(sample.report()))["rules"][0]["worst"]["face"], 1);
  sample.model.brep->labels[1].name.clear();
  EXPECT_EQ(Json::parse(results_json(sample.report()))["rules"][1]["worst"]["face_name"], nullptr);
}

TEST(results_json, numbers_read_back_to_the_same_bits) {
  SampleReport sample;
  sample.rule("failing").worst.value = 0.1 + 0.2;
  const Json json = Json::parse(results_json(sample.report()));
  EXPECT_EQ(json["rules"][1]["worst"]["value"].get<double>(), 0.1 + 0.2);
}

TEST(results_json, what_is_not_finite_is_null) {
  const Json worst = Json::parse(results_json(SampleReport().report()))["rules"][2]["worst"];
  EXPECT_EQ(worst["value"], nullptr);
  EXPECT_EQ(worst["lower"], 3.0);
  EXPECT_EQ(worst["upper"], nullptr);
}

TEST(results_json, names_that_are_not_utf8_do_not_stop_it) {
  SampleReport sample;
  sample.model.file = "part\xFF\"\n.stl";
  EXPECT_EQ(Json::parse(results_json(sample.report()))["model"]["file"], "part\xEF\xBF\xBD\"\n.stl");
}

}  // namespace
}  // namespace gabarit
