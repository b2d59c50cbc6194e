// The rule language with the real selectors and one measure of known parameters.
#pragma once

#include <string>

#include "rules/catalogue.h"
#include "rules/read_rules.h"

namespace gabarit::language {

// Measures `radius` (method, window) and `angle`.
Catalogue catalogue();

Result<RuleSet> read(const std::string& text);

// A file of one rule with this `where` and `require`, each in one line.
std::string with_where(const std::string& where);
std::string with_require(const std::string& require);

// Every message of a file as it would be printed; "fine" when there is none.
std::string errors(const std::string& text);
// "message (hint)" of each.
std::vector<std::string> messages(const std::string& text);

}  // namespace gabarit::language
