#include "tests/report/sample_report.h"

#include <limits>

#include "rules/totals.h"
#include "tests/shapes.h"

namespace gabarit {

static const Measure& radius() {
  static const Measure measure{.name = "radius",
                               .summary = "",
                               .documentation = "",
                               .symbol = "R",
                               .dimension = Dimension::length,
                               .parameters = {},
                               .measure = nullptr};
  return measure;
}

RuleResult sample_result(const std::string& id, Verdict verdict) {
  RuleResult result;
  result.rule.id = id;
  result.rule.title = "Title of " + id;
  result.rule.clause = "2.1";
  result.rule.require = {&radius(), {}, {Limit::Kind::at_least, 4, 0}, "at least 4 mm"};
  result.verdict = verdict;
  return result;
}

static Finding finding(const std::string& id, Verdict verdict, const Worst& worst,
                       std::vector<FacetId> facets) {
  Finding f;
  f.id = id;
  f.verdict = verdict;
  f.facets = std::move(facets);
  f.area = 12.5;
  f.worst = worst;
  f.centroid = {1, 2, 3};
  f.box.add(Vec3d{0, 0, 0});
  f.box.add(Vec3d{10, 20, 30});
  return f;
}

static void measure_facets(RuleResult& result, std::vector<double> lower, std::vector<double> upper,
                           std::vector<FacetVerdict> verdicts) {
  for (std::size_t i = 0; i < lower.size(); ++i) {
    result.field.facets.push_back(static_cast<FacetId>(2 * i));
    result.field.value.push_back((lower[i] + upper[i]) / 2);
    result.field.at.push_back({1, 2, 3});
  }
  result.field.contact = result.field.at;
  result.field.absence.resize(lower.size());
  result.field.lower = std::move(lower);
  result.field.upper = std::move(upper);
  result.facet_verdicts = std::move(verdicts);
  result.facets_examined = result.field.size();
  result.area_examined = 600;
  result.has_worst = true;
  result.worst = {
      result.field.value[0], result.field.lower[0], result.field.upper[0], {1, 2, 3}, {1, 2, 3}, 0};
}

SampleReport::SampleReport() : model(shapes::model(shapes::box({0, 0, 0}, {10, 20, 30}))) {
  model.file = "part.stl";
  model.sha256 = std::string(64, 'a');
  model.bodies = {"body"};
  outcome.rulesets.resize(1);
  outcome.rulesets[0].id = "sample-rules";
  outcome.rulesets[0].revision = "7";
  outcome.rulesets[0].sha256 = std::string(64, 'b');
  outcome.setups.resize(1);
  outcome.device = "cpu";

  const auto p = FacetVerdict::pass, f = FacetVerdict::fail, u = FacetVerdict::undecided;
  RuleResult passing = sample_result("passing", Verdict::pass);
  measure_facets(passing, {5, 6}, {5.5, 6.5}, {p, p});
  RuleResult failing = sample_result("failing", Verdict::fail);
  measure_facets(failing, {2, 1, 5}, {2.5, 1.5, 6}, {f, f, p});
  failing.facets_failed = 2;
  failing.findings = {finding("failing/1", Verdict::fail, failing.worst, {0, 2})};
  RuleResult undecided = sample_result("undecided", Verdict::undecided);
  measure_facets(undecided, {3, 5}, {std::numeric_limits<double>::infinity(), 6}, {u, p});
  undecided.field.value[0] = undecided.worst.value = std::numeric_limits<double>::quiet_NaN();
  undecided.facets_undecided = 1;
  undecided.findings = {finding("undecided/1", Verdict::undecided, undecided.worst, {0})};
  RuleResult absent = sample_result("absent", Verdict::not_applicable);
  absent.reason = "No facet is selected.";
  RuleResult broken = sample_result("broken", Verdict::not_run);
  broken.reason = "It ran out of memory.";
  for (RuleResult* r : {&passing, &failing, &undecided, &absent, &broken}) {
    r->region.facets.assign(model.mesh.facet_count(), Selected::no);
    for (const FacetId facet : r->field.facets) r->region.facets[facet] = Selected::yes;
  }
  outcome.results = {passing, failing, undecided, absent, broken};
  outcome.totals = count(outcome.results);
  outcome.verdict = overall(outcome.results);
}

void SampleReport::add_exact_faces() {
  Brep& brep = model.brep.emplace();
  brep.surfaces.resize(1);
  brep.faces.resize(2);
  for (Face& face : brep.faces) face.surface = 0;
  brep.labels = {{}, {"Deckfläche", {}}};
  brep.facets.resize(model.mesh.facet_count());
  for (FacetOrigin& facet : brep.facets) facet.face = 0;
  brep.facets[0].face = 1;
  for (RuleResult& result : outcome.results) {
    for (Finding& f : result.findings) {
      f.body = "body";
      f.faces = f.facets.size() > 1 ? std::vector<FaceId>{0, 1} : std::vector<FaceId>{1};
    }
  }
}

RuleResult& SampleReport::rule(const std::string& id) {
  for (RuleResult& result : outcome.results) {
    if (result.rule.id == id) return result;
  }
  return outcome.results.front();
}

}  // namespace gabarit
