#include "report/pdf/book.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gabarit::pdf {

static int attention(Verdict verdict) {
  switch (verdict) {
    case Verdict::fail: return 0;
    case Verdict::not_run: return 1;
    case Verdict::undecided: return 2;
    case Verdict::pass: return 3;
    case Verdict::not_applicable: break;
  }
  return 4;
}

// So that all pictures together keep to the megapixels: of the cover and the item page, of a rule's views,
// and of a finding's close-up (see close_up_share).
static double affordable_resolution(const PdfOptions& options, std::size_t rules, std::size_t findings) {
  constexpr double front = 21000, views = 32000, close_up = 13000;  // mm² at full resolution
  const double area = front + views * static_cast<double>(rules) + close_up * static_cast<double>(findings);
  const double dots_an_inch = 25.4 * std::sqrt(options.megapixels * 1e6 / area);
  return std::min(options.resolution, std::max(80.0, dots_an_inch));
}

Book::Book(const Report& r, const PdfOptions& o, Document& document, Fonts& fonts)
    : report(&r), options(&o), flow(document, fonts) {
  for (const RuleResult& result : outcome().results) by_attention.push_back(&result);
  std::stable_sort(by_attention.begin(), by_attention.end(), [](const RuleResult* a, const RuleResult* b) {
    return std::pair(attention(a->verdict), a->rule.severity) <
           std::pair(attention(b->verdict), b->rule.severity);
  });
  with_pages = by_attention;
  if (with_pages.size() > options->limits.rules) with_pages.resize(options->limits.rules);
  std::size_t rules = 0, findings = 0;
  for (const RuleResult* result : with_pages) {
    if (!has_pictures(result->verdict)) continue;
    const std::size_t left = options->limits.findings - findings;
    const bool note = result->rule.severity == Severity::note;
    const std::size_t most = note ? 0 : std::min(options->limits.findings_a_rule, left);
    const std::size_t pages = std::min(result->findings.size(), most);
    finding_pages_[result] = pages;
    findings += pages;
    ++rules;
  }
  resolution = affordable_resolution(*options, rules, findings);
  std::sort(with_pages.begin(), with_pages.end());  // all of one vector: its order
}

std::size_t Book::finding_pages(const RuleResult& result) const {
  const auto found = finding_pages_.find(&result);
  return found == finding_pages_.end() ? 0 : found->second;
}

const Setup& Book::setup_of(const RuleResult& result) const {
  static const Setup plain;
  const std::vector<Setup>& setups = outcome().setups;
  return result.ruleset < setups.size() ? setups[result.ruleset] : plain;
}

}  // namespace gabarit::pdf
