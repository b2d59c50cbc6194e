#include "rules/rule_text.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

#include <fmt/format.h>

namespace gabarit {

void RuleText::error(const YamlNode& at, std::string message, std::string hint) {
  YamlNode where;  // without what hangs below
  where.line = at.line;
  where.column = at.column;
  where.length = at.length;
  found_.push_back({std::move(where), std::move(message), std::move(hint)});
}

Place RuleText::place(const YamlNode& node) const {
  return {std::filesystem::path(*name_).filename().string(), node.line, node.column};
}

Diagnostics RuleText::all_errors(Diagnostics others) {
  constexpr std::size_t most = 100;
  const auto earlier = [](const auto& a, const auto& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  };
  std::stable_sort(found_.begin(), found_.end(),
                   [&](const Fault& a, const Fault& b) { return earlier(a.at, b.at); });
  const std::size_t total = found_.size() + others.size();
  for (const Fault& fault : found_) {
    if (others.size() >= 2 * most) break;
    others.push_back(diagnostic_at(*name_, *text_, fault.at, fault.message, fault.hint));
  }
  std::stable_sort(others.begin(), others.end(), earlier);
  if (total > most) {
    others.resize(most);
    others.push_back({.file = *name_, .message = fmt::format("{} more errors", total - most)});
  }
  return others;
}

}  // namespace gabarit
