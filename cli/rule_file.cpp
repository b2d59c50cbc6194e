#include "cli/rule_file.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace gabarit {

namespace fs = std::filesystem;

static std::vector<std::string> packs_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder, error); !error && it != fs::directory_iterator();
       it.increment(error))
    names.push_back(it->path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

static Diagnostics neither(const std::string& name, const fs::path& installed) {
  if (installed.empty())
    return {
        {.file = name,
         .message = "there is no such file, and the rule packs of the program were not found",
         .hint =
             "they lie in share/gabarit/rules beside the program's bin; name a rule file with its folder"}};
  const fs::path folder = installed / "rules";
  return {
      {.file = name,
       .message = "there is no such file, and no rule pack of that name came with the program",
       .hint = fmt::format("the packs in {} are: {}", folder.string(), fmt::join(packs_in(folder), ", "))}};
}

Result<RuleSet> read_named_rules(const std::string& name, const fs::path& installed) {
  std::error_code error;
  const fs::path given(name);
  if (fs::exists(given, error) || given.has_parent_path() || name.empty()) return read_rules(given);
  for (const std::string& file : {name, name + ".yaml"}) {
    const fs::path pack = installed / "rules" / file;
    if (!installed.empty() && fs::is_regular_file(pack, error)) return read_rules(pack);
  }
  // With an ending a file is meant.
  return given.has_extension() ? read_rules(given) : neither(name, installed);
}

}  // namespace gabarit
