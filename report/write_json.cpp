#include "report/write_json.h"

#include <nlohmann/json.hpp>

#include "report/display_unit.h"
#include "report/distribution.h"

namespace gabarit {

using Json = nlohmann::ordered_json;

static Json point(const Vec3d& p) { return Json::array({p.x, p.y, p.z}); }

static Json box(const Box3d& b) { return {{"min", point(b.min)}, {"max", point(b.max)}}; }

// The exact face that a facet lies on: its number, counted from 0, and its name where the file has one.
static void add_face(Json& json, const Model& m, FacetId facet) {
  const bool exact = m.brep && facet < m.brep->facets.size();
  const FaceId face = exact ? m.brep->facets[facet].face : no_number;
  const bool named = exact && face < m.brep->labels.size() && !m.brep->labels[face].name.empty();
  json["face"] = exact ? Json(face) : Json();
  json["face_name"] = named ? Json(m.brep->labels[face].name) : Json();
}

static Json worst(const Worst& w, const DisplayUnit& unit, const Model& m) {
  Json json = {{"value", w.value * unit.factor},
               {"lower", w.lower * unit.factor},
               {"upper", w.upper * unit.factor},
               {"unit", unit.name},
               {"at", point(w.at)},
               {"facet", w.facet}};
  const std::uint32_t body = w.facet < m.mesh.facet_count() ? m.mesh.body_of(w.facet) : no_number;
  json["body"] = body < m.bodies.size() ? Json(m.bodies[body]) : Json();
  add_face(json, m, w.facet);
  return json;
}

static Json model(const Report& report) {
  const Model& m = *report.model;
  const Defects& d = m.defects;
  const Json sag = report.outcome->setups.empty() ? Json() : Json(report.outcome->setups.front().sag);
  return {{"file", m.file},
          {"sha256", m.sha256},
          {"unit", name(m.unit)},
          {"facets", m.mesh.facet_count()},
          {"bodies", m.bodies.size()},
          {"box", box(m.box)},
          {"sag", sag},
          {"watertight", watertight(d)},
          {"defects",
           {{"not_finite", d.not_finite},
            {"degenerate", d.degenerate},
            {"duplicate", d.duplicate},
            {"open_edges", d.open_edges},
            {"non_manifold_edges", d.non_manifold_edges},
            {"misoriented_edges", d.misoriented_edges}}}};
}

static Json limit(const Requirement& require, const DisplayUnit& unit) {
  const Limit& l = require.limit;
  Json json = {{"measure", require.measure != nullptr ? require.measure->name : ""},
               {"text", require.limit_text}};
  if (l.kind != Limit::Kind::at_most) json["at_least"] = l.low * unit.factor;
  if (l.kind != Limit::Kind::at_least) json["at_most"] = l.high * unit.factor;
  json["unit"] = unit.name;
  return json;
}

static Json finding(const Finding& f, const DisplayUnit& unit, const Model& m) {
  return {{"id", f.id},
          {"verdict", name(f.verdict)},
          {"facets", f.facets.size()},
          {"area", f.area},
          {"worst", worst(f.worst, unit, m)},
          {"centroid", point(f.centroid)},
          {"box", box(f.box)},
          {"faces", f.faces}};
}

static Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

// Over the examined area; null when no facet has a finite value.
static Json statistics(const RuleResult& r, const TriangleMesh& mesh) {
  const std::optional<Histogram> h = coarse_distribution(r, mesh);
  if (!h) return {};
  Json ranges = Json::array();
  for (const ValueRange& range :
       value_ranges(*h, displayed(r.rule.require.limit, display_factor(r.rule.require)))) {
    ranges.push_back({{"from", number(range.from)},
                      {"to", number(range.to)},
                      {"area", range.area},
                      {"share", range.share},
                      {"critical", range.critical}});
  }
  return {{"minimum", h->minimum},
          {"maximum", h->maximum},
          {"mean", h->mean},
          {"critical_area", h->critical_area},
          {"failed_area", r.area_failed},
          {"undecided_area", r.area_undecided},
          {"area_without_value", h->area_without},
          {"ranges", std::move(ranges)}};
}

static const char* severity(Severity s) {
  return s == Severity::error ? "error" : s == Severity::warning ? "warning" : "note";
}

static Json rule(const RuleResult& r, const Model& m) {
  const Measure* const measure = r.rule.require.measure;
  const DisplayUnit unit = display_unit(measure != nullptr ? measure->dimension : Dimension::length);
  Json findings = Json::array();
  for (const Finding& f : r.findings) findings.push_back(finding(f, unit, m));
  return {{"id", r.rule.id},
          {"title", r.rule.title},
          {"clause", r.rule.clause},
          {"severity", severity(r.rule.severity)},
          {"verdict", name(r.verdict)},
          {"reason", r.reason},
          {"facets_examined", r.facets_examined},
          {"area_examined", r.area_examined},
          {"facets_failed", r.facets_failed},
          {"worst", r.has_worst ? worst(r.worst, unit, m) : Json()},
          {"limit", limit(r.rule.require, unit)},
          {"findings", std::move(findings)},
          {"statistics", statistics(r, m.mesh)}};
}

static Json totals(const Totals& t) {
  return {{"planned", t.planned},
          {"passed", t.passed},
          {"failed", t.failed},
          {"undecided", t.undecided},
          {"not_applicable", t.not_applicable},
          {"not_run", t.not_run},
          {"waived", t.waived}};
}

std::string results_json(const Report& report) {
  const Outcome& outcome = *report.outcome;
  Json rulesets = Json::array();
  for (const RuleSet& set : outcome.rulesets) {
    rulesets.push_back({{"id", set.id}, {"revision", set.revision}, {"sha256", set.sha256}});
  }
  Json rules = Json::array();
  for (const RuleResult& result : outcome.results) rules.push_back(rule(result, *report.model));
  const Json json = {{"schema", "gabarit.results/1"},    {"gabarit", report.version},
                     {"verdict", name(outcome.verdict)}, {"model", model(report)},
                     {"rulesets", std::move(rulesets)},  {"device", outcome.device},
                     {"rules", std::move(rules)},        {"totals", totals(outcome.totals)}};
  // Names in a model may hold bytes that are not UTF-8; they are replaced, never a reason to write nothing.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace gabarit
