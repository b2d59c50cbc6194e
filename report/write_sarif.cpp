#include "report/write_sarif.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/sha256.h"
#include "report/finding_text.h"

namespace gabarit {

using Json = nlohmann::ordered_json;

static const char* level(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

static const char* kind(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass: return "pass";
    case Verdict::fail: return "fail";
    case Verdict::not_applicable: return "notApplicable";
    case Verdict::undecided:
    case Verdict::not_run: break;
  }
  return "open";
}

// A file name as a relative URI reference.
static std::string uri(const std::string& file) {
  std::string escaped;
  for (const char c : file) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '.' || c == '-' || c == '_' || c == '~';
    escaped += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return escaped;
}

static Json location(const Report& report, const std::string& body, const std::string& face) {
  Json json = {{"physicalLocation", {{"artifactLocation", {{"uri", uri(report.model->file)}}}}}};
  Json names = Json::array();
  for (const std::string& part : {body, face}) {
    if (!part.empty()) names.push_back({{"name", part}, {"kind", "object"}});
  }
  if (!names.empty()) json["logicalLocations"] = std::move(names);
  return json;
}

static Json result(const Report& report, const RuleResult& rule, std::size_t index, Verdict verdict,
                   const std::string& text) {
  return {
      {"ruleId", rule.rule.id},      {"ruleIndex", index},
      {"kind", kind(verdict)},       {"level", verdict == Verdict::fail ? level(rule.rule.severity) : "none"},
      {"message", {{"text", text}}}, {"locations", Json::array({location(report, {}, {})})}};
}

// The same patch of another revision of the model should have the same print: its rule and its place to 10
// mm.
static std::string fingerprint(const RuleResult& rule, const Finding& finding) {
  const Vec3d& c = finding.centroid;
  return sha256(fmt::format("{} {:.0f} {:.0f} {:.0f}", rule.rule.id, c.x / 10, c.y / 10, c.z / 10));
}

static Json finding_result(const Report& report, const RuleResult& rule, std::size_t index,
                           const Finding& f) {
  Json json =
      result(report, rule, index, f.verdict, f.id + ": " + worst_sentence(f.worst, rule.rule.require));
  json["locations"] = Json::array({location(report, f.body, face_text(*report.model, f.worst.facet))});
  json["partialFingerprints"] = {{"gabaritPlace/v1", fingerprint(rule, f)}};
  json["properties"] = {{"finding", f.id},
                        {"facets", f.facets.size()},
                        {"area", f.area},
                        {"at", Json::array({f.worst.at.x, f.worst.at.y, f.worst.at.z})}};
  return json;
}

static Json notification(const std::string& rule, const char* how_bad, const std::string& text) {
  Json json = {{"level", how_bad}, {"message", {{"text", text}}}};
  if (!rule.empty()) json["associatedRule"] = {{"id", rule}};
  return json;
}

struct Results {
  Json list = Json::array(), notifications = Json::array();
  std::size_t left_out = 0;

  void add(Json json) {
    constexpr std::size_t cap = 25000;
    list.size() < cap ? list.push_back(std::move(json)) : void(++left_out);
  }
};

static void add_rule(const Report& report, std::size_t index, Results& results) {
  const RuleResult& rule = report.outcome->results[index];
  const bool not_run = rule.verdict == Verdict::not_run;
  // A rule whose verdict no listed finding carries (it passed, or its findings are too small to be listed)
  // still says what became of it.
  const bool shown = std::any_of(rule.findings.begin(), rule.findings.end(),
                                 [&](const Finding& f) { return f.verdict == rule.verdict; });
  if (!shown) {
    const std::string text = not_run ? "Not run: " + rule.reason : rule_sentence(rule);
    results.add(result(report, rule, index, rule.verdict, text));
  }
  for (const Finding& f : rule.findings) results.add(finding_result(report, rule, index, f));
  if (not_run)
    results.notifications.push_back(notification(rule.rule.id, "error", "Not run: " + rule.reason));
}

static Json catalogue(const Outcome& outcome) {
  Json rules = Json::array();
  for (const RuleResult& r : outcome.results) {
    const std::string title = r.rule.title.empty() ? r.rule.id : r.rule.title;
    rules.push_back({{"id", r.rule.id},
                     {"shortDescription", {{"text", title}}},
                     {"defaultConfiguration", {{"level", level(r.rule.severity)}}},
                     {"properties", {{"clause", r.rule.clause}, {"limit", r.rule.require.limit_text}}}});
  }
  return rules;
}

std::string sarif_json(const Report& report) {
  Results results;
  for (std::size_t i = 0; i < report.outcome->results.size(); ++i) add_rule(report, i, results);
  if (results.left_out > 0) {
    results.notifications.push_back(
        notification("", "warning",
                     fmt::format("{} results are left out here; results.json holds all.", results.left_out)));
  }
  const Json driver = {{"name", "gabarit"},
                       {"version", report.version},
                       {"semanticVersion", report.version},
                       {"rules", catalogue(*report.outcome)}};
  const Json artifact = {{"location", {{"uri", uri(report.model->file)}}},
                         {"hashes", {{"sha-256", report.model->sha256}}}};
  const Json invocation = {{"executionSuccessful", report.outcome->totals.not_run == 0},
                           {"toolExecutionNotifications", std::move(results.notifications)}};
  const Json run = {{"tool", {{"driver", driver}}},
                    {"invocations", Json::array({invocation})},
                    {"artifacts", Json::array({artifact})},
                    {"results", std::move(results.list)}};
  const Json json = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                     {"version", "2.1.0"},
                     {"runs", Json::array({run})}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace gabarit
