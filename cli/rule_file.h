// Which file a user means by the name of a rule file.
#pragma once

#include <filesystem>
#include <string>

#include "rules/read_rules.h"

namespace gabarit {

// The rules of a file of that name, else of the pack of that name (with or without .yaml) that came with the
// program. `installed`: see report/installation.h; empty when nothing was found.
Result<RuleSet> read_named_rules(const std::string& name, const std::filesystem::path& installed);

}  // namespace gabarit
