// Names of rules and rule sets, which become names of files.
#pragma once

#include <optional>
#include <string>

namespace gabarit {

// Why it can't be an id; nothing when it can: letters, digits, `.`, `_` and `-`, at most 64, not beginning
// with `.` or `-`, not ending with `.`, and no name that a file system reserves (CON, NUL, COM1, …).
std::optional<std::string> fault_of_identifier(const std::string& id);

// Ids with the same key name the same file where case does not count.
std::string identifier_key(std::string id);

}  // namespace gabarit
