#include <map>

#include <fmt/format.h>

#include "rules/engine.h"
#include "rules/nearest_name.h"

namespace gabarit {

static Diagnostic shared_id(const Rule& rule, const Place& first) {
  return {
      .file = rule.place.file,
      .line = rule.place.line,
      .column = rule.place.column,
      .message = fmt::format("the rule id `{}` is already used at {}:{}", rule.id, first.file, first.line),
      .hint = "ids name output files: give every rule of a run its own"};
}

Diagnostics check_selection(std::span<const RuleSet> rulesets, std::span<const std::string> only) {
  Diagnostics found;
  std::map<std::string, Place> known;
  std::vector<std::string> ids;
  for (const RuleSet& rules : rulesets) {
    for (const Rule& rule : rules.rules) {
      const auto [there, fresh] = known.emplace(rule.id, rule.place);
      if (fresh) {
        ids.push_back(rule.id);
      } else {
        found.push_back(shared_id(rule, there->second));
      }
    }
  }
  for (const std::string& id : only) {
    if (known.contains(id)) continue;
    found.push_back(
        {.file = {}, .message = fmt::format("no rule has the id `{}`", id), .hint = name_hint(id, ids)});
  }
  return found;
}

}  // namespace gabarit
