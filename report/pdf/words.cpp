#include "report/pdf/words.h"

#include <cmath>

#include <fmt/format.h>

#include "report/display_unit.h"
#include "report/finding_text.h"
#include "report/number_text.h"

namespace gabarit::pdf {

std::string grouped(std::string digits) {
  if (digits.size() <= 4) return digits;
  for (std::size_t from_right = 3; from_right < digits.size(); from_right += 3 + 3) {
    digits.insert(digits.size() - from_right, "\u202F");  // three bytes
  }
  return digits;
}

std::string count_text(std::size_t count) { return grouped(std::to_string(count)); }

std::string counted(std::size_t count, const std::string& noun) {
  return count_text(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string place_text(const Vec3d& p) {
  return is_finite(p) ? fmt::format("({:.1f}, {:.1f}, {:.1f})", p.x, p.y, p.z) : "unknown";
}

std::string unit_text(const Requirement& require) {
  const std::string name =
      display_unit(require.measure != nullptr ? require.measure->dimension : Dimension::length).name;
  return name == "mm2" ? "mm²" : name == "deg" ? "°" : name;
}

std::string measured_text(double value, const Requirement& require) {
  const std::string text = value_text(value, require);
  return std::isfinite(value) ? text + " " + unit_text(require) : text;
}

std::string bounds_text(const Worst& worst, const Requirement& require) {
  return value_text(worst.lower, require) + " to " + value_text(worst.upper, require);
}

std::string area_number(double area) {
  const bool large = area >= 1000 && area < 1e15;
  return large ? count_text(static_cast<std::size_t>(std::llround(area))) : number_text(area);
}

std::string area_text(double area) { return area_number(area) + " mm²"; }

std::string length_text(double length) { return fmt::format("{:g} mm", length); }

std::string overall_sentence(const Outcome& outcome) {
  switch (outcome.verdict) {
    case Verdict::fail: return "At least one rule is broken, beyond the bounds of its measurement.";
    case Verdict::not_run:
      return "No rule is proven broken, but not every planned rule was run: nothing is released.";
    case Verdict::undecided: return "No rule is proven broken, but the measurement cannot decide every one.";
    case Verdict::pass: return "Every rule that applies is met, within the bounds of its measurement.";
    case Verdict::not_applicable: break;
  }
  return "No rule found anything on this model to look at.";
}

std::string totals_sentence(const Totals& t) {
  return fmt::format(
      "{} planned: {} failed, {} not run, {} undecided, {} passed, {} not applicable; {} waived",
      counted(t.planned, "rule"), count_text(t.failed), count_text(t.not_run), count_text(t.undecided),
      count_text(t.passed), count_text(t.not_applicable), count_text(t.waived));
}

const char* severity_word(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

std::string measure_text(const Requirement& require) {
  if (require.measure == nullptr) return "value";
  return require.measure->symbol.empty() ? require.measure->name
                                         : require.measure->name + " " + require.measure->symbol;
}

}  // namespace gabarit::pdf
