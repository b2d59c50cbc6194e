// YAML → RuleSet, with every error of the file at its line and column in one go.
#pragma once

#include <filesystem>
#include <string>

#include "model/result.h"
#include "rules/catalogue.h"
#include "rules/rule.h"

namespace gabarit {

Result<RuleSet> read_rules(const std::filesystem::path& file, const Catalogue& catalogue = {});
// `name` stands for the file in messages.
Result<RuleSet> read_rules_text(const std::string& text, const std::string& name,
                                const Catalogue& catalogue = {});

}  // namespace gabarit
