#include "rules/judge_field.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "rules/findings.h"
#include "rules/region.h"
#include "rules/worst.h"

namespace gabarit {

namespace {

// A facet that is selected but not measured would pass without a word.
void check_complete(const RuleResult& result) {
  const Field& field = result.field;
  const std::size_t n = field.size();
  const bool whole = field.value.size() == n && field.lower.size() == n && field.upper.size() == n &&
                     field.at.size() == n && field.contact.size() == n && field.absence.size() == n;
  std::size_t next = 0;
  for (FacetId f = 0; whole && f < result.region.facets.size(); ++f) {
    if (result.region.facets[f] == Selected::no) continue;
    if (next == n || field.facets[next] != f) break;
    ++next;
  }
  const auto selected =
      static_cast<std::size_t>(std::count_if(result.region.facets.begin(), result.region.facets.end(),
                                             [](Selected s) { return s != Selected::no; }));
  if (!whole || next != n || next != selected) {
    throw std::logic_error(fmt::format("`{}` measured {} facets of the {} selected ones",
                                       result.rule.require.measure->name, n, selected));
  }
}

bool covers_nothing(const TriangleMesh& mesh, FacetId f) {
  const auto corners = mesh.corners(f);
  return std::all_of(corners.begin(), corners.end(), [](const Vec3d& c) { return is_finite(c); }) &&
         facet_normal(mesh, f) == Vec3d{};
}

// The entries that were examined.
std::vector<std::size_t> judge_facets(const TriangleMesh& mesh, RuleResult& result) {
  const Field& field = result.field;
  std::vector<std::size_t> examined;
  result.facet_verdicts.assign(field.size(), FacetVerdict::not_examined);
  for (std::size_t i = 0; i < field.size(); ++i) {
    const FacetId f = field.facets[i];
    if (field.absence[i] == Absence::degenerate && covers_nothing(mesh, f)) continue;
    const FacetVerdict verdict =
        judge(field.lower[i], field.upper[i], result.rule.require.limit, result.region.facets[f]);
    result.facet_verdicts[i] = verdict;
    examined.push_back(i);
    const double area = facet_area(mesh, f);
    result.area_examined += area;
    if (verdict == FacetVerdict::fail) ++result.facets_failed, result.area_failed += area;
    if (verdict == FacetVerdict::undecided) ++result.facets_undecided, result.area_undecided += area;
  }
  result.facets_examined = examined.size();
  return examined;
}

const char* why_undecided(const RuleResult& result, std::size_t entry) {
  const Field& field = result.field;
  switch (field.absence[entry]) {
    case Absence::open: return "nothing bounds the measure: the mesh is open or no wall lies opposite";
    case Absence::degenerate: return "there is no normal";
    case Absence::buried: return "the facet lies inside the part, the mesh overlaps itself";
    case Absence::too_little: return "the mesh turns too little to tell";
    case Absence::none: break;
  }
  const FacetVerdict if_selected =
      judge(field.lower[entry], field.upper[entry], result.rule.require.limit, Selected::yes);
  return if_selected == FacetVerdict::fail ? "it is not certain that the rule looks there"
                                           : "the limit lies between the bounds";
}

// Small areas keep their digits.
std::string area_text(double area) {
  return area < 10 ? fmt::format("{:.3g}", area) : fmt::format("{:.1f}", area);
}

std::string undecided_reason(const RuleResult& result) {
  std::vector<std::pair<std::string_view, std::size_t>> causes;
  for (std::size_t i = 0; i < result.facet_verdicts.size(); ++i) {
    if (result.facet_verdicts[i] != FacetVerdict::undecided) continue;
    const std::string_view cause = why_undecided(result, i);
    const auto known =
        std::find_if(causes.begin(), causes.end(), [&](const auto& c) { return c.first == cause; });
    if (known == causes.end()) {
      causes.emplace_back(cause, 1);
    } else {
      ++known->second;
    }
  }
  std::stable_sort(causes.begin(), causes.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text = fmt::format("Undecided on {} of {} facets ({} mm²)", result.facets_undecided,
                                 result.facets_examined, area_text(result.area_undecided));
  for (std::size_t i = 0; i < causes.size(); ++i) {
    text += fmt::format("{} {} ({})", i == 0 ? ":" : ";", causes[i].first, causes[i].second);
  }
  return text + ".";
}

void decide(RuleResult& result) {
  if (result.facets_failed > 0) {
    result.verdict = Verdict::fail;
  } else if (result.facets_undecided > 0) {
    result.verdict = Verdict::undecided;
    result.reason = undecided_reason(result);
  } else if (result.field.size() == 0) {
    result.verdict = Verdict::not_applicable;
    result.reason =
        fmt::format("No facet is selected: the rule looks at facets where {}.", describe(result.rule.where));
  } else if (result.facets_examined == 0) {
    result.verdict = Verdict::undecided;
    result.reason = fmt::format("All {} selected facets are degenerate: there is no surface to measure.",
                                result.field.size());
  } else {
    result.verdict = Verdict::pass;
  }
}

void note_degenerate(RuleResult& result) {
  const std::size_t count = result.field.size() - result.facets_examined;
  if (count == 0) return;
  std::string note =
      count == 1
          ? "One selected facet has no area: it covers no surface and was not judged."
          : fmt::format("{} selected facets have no area: they cover no surface and were not judged.", count);
  std::vector<std::string>& notes = result.field.notes;
  if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(std::move(note));
}

}  // namespace

void judge_field(const Model& model, RuleResult& result) {
  check_complete(result);
  const std::vector<std::size_t> examined = judge_facets(model.mesh, result);
  note_degenerate(result);
  Findings findings = find_patches(model, result.rule, result.field, result.facet_verdicts);
  result.findings = std::move(findings.listed);
  result.findings_ignored = findings.ignored;
  result.has_worst = !examined.empty();
  if (result.has_worst) {
    result.worst = worst_at(
        result.field, worst_entry(result.field, result.facet_verdicts, result.rule.require.limit, examined));
  }
  decide(result);
}

}  // namespace gabarit
