#include "report/pdf/book.h"

#include <algorithm>
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

Book::Book(const Report& r, const PdfOptions& o, Document& document, Fonts& fonts)
    : report(&r), options(&o), flow(document, fonts) {
  for (const RuleResult& result : outcome().results) by_attention.push_back(&result);
  std::stable_sort(by_attention.begin(), by_attention.end(), [](const RuleResult* a, const RuleResult* b) {
    return std::pair(attention(a->verdict), a->rule.severity) <
           std::pair(attention(b->verdict), b->rule.severity);
  });
  with_pages = by_attention;
  if (with_pages.size() > options->limits.rules) with_pages.resize(options->limits.rules);
  std::sort(with_pages.begin(), with_pages.end());  // all of one vector: its order
}

const Setup& Book::setup_of(const RuleResult& result) const {
  static const Setup plain;
  const std::vector<Setup>& setups = outcome().setups;
  return result.ruleset < setups.size() ? setups[result.ruleset] : plain;
}

}  // namespace gabarit::pdf
