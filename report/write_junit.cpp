#include "report/write_junit.h"

#include <fmt/format.h>

#include "report/finding_text.h"
#include "report/xml_text.h"

namespace gabarit {

struct Counts {
  std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;

  void add(Verdict verdict) {
    ++tests;
    failures += verdict == Verdict::fail ? 1 : 0;
    errors += verdict == Verdict::undecided || verdict == Verdict::not_run ? 1 : 0;
    skipped += verdict == Verdict::not_applicable ? 1 : 0;
  }
  std::string attributes() const {
    return fmt::format(R"(tests="{}" failures="{}" errors="{}" skipped="{}")", tests, failures, errors,
                       skipped);
  }
};

// "failing/1: radius 2.25 mm …, body tank, face 12 'Top', a plane; over faces 3, 12".
static std::string finding_line(const Finding& f, const RuleResult& result, const Model& model) {
  const std::string face = face_text(model, f.worst.facet), faces = faces_text(f);
  std::string text =
      fmt::format("{} {}: {}", name(f.verdict), f.id, worst_sentence(f.worst, result.rule.require));
  for (const std::string& part : {f.body.empty() ? "" : "body " + f.body, face}) {
    if (!part.empty()) text += ", " + part;
  }
  return text + (faces.empty() ? "" : "; over " + faces) + '\n';
}

static std::string body(const RuleResult& result, const Model& model) {
  constexpr std::size_t listed = 100;
  std::string text = rule_sentence(result) + '\n';
  for (std::size_t i = 0; i < result.findings.size() && i < listed; ++i) {
    text += finding_line(result.findings[i], result, model);
  }
  if (result.findings.size() > listed) text += fmt::format("… {} findings in all\n", result.findings.size());
  return text;
}

static std::string element(const char* tag, const RuleResult& result, const Model& model) {
  return fmt::format("      <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n", tag, name(result.verdict),
                     xml_text(rule_sentence(result)), xml_text(body(result, model)));
}

static std::string outcome_element(const RuleResult& result, const Model& model) {
  switch (result.verdict) {
    case Verdict::pass:
      return fmt::format("      <system-out>{}</system-out>\n", xml_text(rule_sentence(result)));
    case Verdict::not_applicable:
      return fmt::format("      <skipped message=\"{}\"/>\n", xml_text(rule_sentence(result)));
    case Verdict::fail: return element("failure", result, model);
    case Verdict::undecided:
    case Verdict::not_run: break;
  }
  return element("error", result, model);
}

static std::string suite(const Report& report, std::size_t set) {
  std::string cases;
  Counts counts;
  const RuleSet& rules = report.outcome->rulesets[set];
  for (const RuleResult& result : report.outcome->results) {
    if (result.ruleset != set) continue;
    counts.add(result.verdict);
    cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\">\n{}    </testcase>\n",
                         xml_text(rules.id), xml_text(result.rule.id + ": " + result.rule.title),
                         outcome_element(result, *report.model));
  }
  return fmt::format("  <testsuite name=\"{}\" {}>\n{}  </testsuite>\n", xml_text(rules.id),
                     counts.attributes(), cases);
}

std::string junit_xml(const Report& report) {
  Counts counts;
  std::string suites;
  for (const RuleResult& result : report.outcome->results) counts.add(result.verdict);
  for (std::size_t set = 0; set < report.outcome->rulesets.size(); ++set) suites += suite(report, set);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"gabarit {}\" {}>\n{}</testsuites>\n",
      xml_text(report.model->file), counts.attributes(), suites);
}

}  // namespace gabarit
