// Which file a user means by the name of a rule file.
#pragma once

#include <string>

namespace gabarit {

// A file of that name, else the pack of that name (with or without .yaml) that came with the program; the
// name itself when there is neither.
std::string rule_file(const std::string& name);

}  // namespace gabarit
