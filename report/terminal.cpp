#include "report/terminal.h"

#include <array>

#include <fmt/format.h>

#include "report/finding_text.h"
#include "report/number_text.h"

namespace gabarit {

struct Look {
  const char* word;
  const char* colour;
};

static Look look(Verdict verdict) {
  switch (verdict) {
    case Verdict::fail: return {"FAIL", "\033[1;31m"};
    case Verdict::not_run: return {"NOT RUN", "\033[1;35m"};
    case Verdict::undecided: return {"UNDECIDED", "\033[1;33m"};
    case Verdict::pass: return {"PASS", "\033[1;32m"};
    case Verdict::not_applicable: break;
  }
  return {"NOT APPLICABLE", "\033[2m"};
}

static std::string printable(std::string text) {
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) c = '?';
  }
  // The control characters of C1 take two bytes in UTF-8.
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text[i] == '\xC2' && static_cast<unsigned char>(text[i + 1]) < 0xA0) text[i] = text[i + 1] = '?';
  }
  return text;
}

static std::string verdict_word(Verdict verdict, const TerminalStyle& style) {
  const Look l = look(verdict);
  return style.colour ? fmt::format("{}{:<14}\033[0m", l.colour, l.word) : fmt::format("{:<14}", l.word);
}

static std::string line(const std::string& text) { return std::string(15, ' ') + printable(text) + '\n'; }

static std::string counted(std::size_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

static std::string finding_line(const Finding& f, const RuleResult& result, const Model& model) {
  const std::string face = face_text(model, f.worst.facet);
  return line(fmt::format("{}  {}: {}; {}, {} mm²{}{}", f.id, name(f.verdict),
                          worst_sentence(f.worst, result.rule.require),
                          counted(f.facets.size(), "facet", "facets"), number_text(f.area),
                          f.body.empty() ? "" : ", body " + f.body, face.empty() ? "" : ", " + face));
}

static std::string findings(const RuleResult& result, const TerminalStyle& style, const Model& model) {
  std::string text;
  for (std::size_t i = 0; i < result.findings.size() && i < style.findings; ++i) {
    text += finding_line(result.findings[i], result, model);
  }
  if (result.findings.size() > style.findings)
    text += line(fmt::format("… {} in all", result.findings.size()));
  if (result.findings_ignored > 0) {
    text += line(fmt::format("{} more smaller than {} mm², not listed", result.findings_ignored,
                             number_text(result.rule.ignore_area)));
  }
  return text;
}

static std::string rule_block(const RuleResult& result, const TerminalStyle& style, const Model& model) {
  std::string text = fmt::format("{} {}\n", verdict_word(result.verdict, style),
                                 printable(result.rule.id + "  " + result.rule.title));
  if (!result.reason.empty()) text += line(result.reason);
  if (result.has_worst) text += line("worst: " + worst_sentence(result.worst, result.rule.require));
  if (result.verdict == Verdict::not_run) return text + '\n';
  std::string counts = examined_text(result);
  if (result.facets_undecided > 0) counts = fmt::format("{} undecided, ", result.facets_undecided) + counts;
  if (result.facets_failed > 0) counts = fmt::format("{} failed, ", result.facets_failed) + counts;
  return text + line(counts) + findings(result, style, model) + '\n';
}

static std::string heading(const Report& report) {
  const Model& m = *report.model;
  const Vec3d size = m.box.extent();
  return printable(fmt::format("gabarit {}  {}  {}, {}, {} × {} × {} mm", report.version, m.file,
                               counted(m.mesh.facet_count(), "facet", "facets"),
                               counted(m.bodies.size(), "body", "bodies"), number_text(size.x),
                               number_text(size.y), number_text(size.z))) +
         "\n\n";
}

static std::string totals_line(const Outcome& outcome, const TerminalStyle& style) {
  const Totals& t = outcome.totals;
  return fmt::format(
      "{} {} rules planned: {} failed, {} not run, {} undecided, {} passed, {} not applicable, {} waived\n",
      verdict_word(outcome.verdict, style), t.planned, t.failed, t.not_run, t.undecided, t.passed,
      t.not_applicable, t.waived);
}

std::string terminal_report(const Report& report, const TerminalStyle& style) {
  constexpr std::array order{Verdict::fail, Verdict::not_run, Verdict::undecided, Verdict::pass,
                             Verdict::not_applicable};
  std::string text = heading(report);
  for (const Verdict verdict : order) {
    for (const RuleResult& result : report.outcome->results) {
      if (result.verdict == verdict) text += rule_block(result, style, *report.model);
    }
  }
  return text + totals_line(*report.outcome, style);
}

}  // namespace gabarit
