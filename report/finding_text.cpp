#include "report/finding_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/display_unit.h"
#include "report/number_text.h"

namespace gabarit {

// The bound of the limit that a value is nearest to.
static double nearest_bound(double value, const Limit& limit) {
  if (limit.kind == Limit::Kind::at_least) return limit.low;
  if (limit.kind == Limit::Kind::at_most) return limit.high;
  return std::abs(value - limit.low) < std::abs(value - limit.high) ? limit.low : limit.high;
}

static DisplayUnit unit_of(const Requirement& require) {
  return display_unit(require.measure != nullptr ? require.measure->dimension : Dimension::length);
}

std::string value_text(double value, const Requirement& require) {
  const double factor = unit_of(require).factor;
  return number_text(value * factor, nearest_bound(value, require.limit) * factor);
}

// With the unit behind numbers, not behind "unknown" and "unlimited".
static std::string with_unit(double value, const Requirement& require) {
  const std::string unit = unit_of(require).name;
  return value_text(value, require) + (std::isfinite(value) && !unit.empty() ? ' ' + unit : "");
}

std::string worst_sentence(const Worst& w, const Requirement& require) {
  const std::string place =
      is_finite(w.at) ? fmt::format("at ({:.1f}, {:.1f}, {:.1f})", w.at.x, w.at.y, w.at.z) : "place unknown";
  return fmt::format("{} {} ({} to {}), required: {}, {}",
                     require.measure != nullptr ? require.measure->name : "value",
                     with_unit(w.value, require), value_text(w.lower, require), value_text(w.upper, require),
                     require.limit_text, place);
}

std::string face_text(const Model& model, FacetId facet) {
  if (!model.brep || facet >= model.brep->facets.size()) return "";
  const Brep& brep = *model.brep;
  const FaceId face = brep.facets[facet].face;
  const std::string name = face < brep.labels.size() ? brep.labels[face].name : "";
  const SurfaceKind kind = brep.surfaces[brep.faces[face].surface].kind;
  return fmt::format("face {}{}, {} {}", face, name.empty() ? "" : " '" + name + "'",
                     kind == SurfaceKind::extrusion ? "an" : "a", gabarit::name(kind));
}

std::string faces_text(const Finding& finding) {
  constexpr std::size_t most = 8;
  if (finding.faces.size() < 2) return "";
  std::string text = "faces ";
  for (std::size_t i = 0; i < std::min(most, finding.faces.size()); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : ", ", finding.faces[i]);
  return finding.faces.size() > most ? fmt::format("{} and {} more", text, finding.faces.size() - most)
                                     : text;
}

std::string examined_text(const RuleResult& result) {
  return fmt::format("of {} facets, {} mm² examined", result.facets_examined,
                     number_text(result.area_examined));
}

std::string rule_sentence(const RuleResult& result) {
  std::string text;
  if (result.verdict == Verdict::fail) text = fmt::format("{} facets fail, ", result.facets_failed);
  if (result.verdict == Verdict::undecided)
    text = fmt::format("{} facets are undecided, ", result.facets_undecided);
  text += examined_text(result) + '.';
  if (result.has_worst) text += " Worst: " + worst_sentence(result.worst, result.rule.require) + '.';
  if (!result.reason.empty()) text += ' ' + result.reason;
  return text;
}

}  // namespace gabarit
