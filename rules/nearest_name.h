// What somebody probably meant who wrote a name that does not exist.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gabarit {

// The known name with the fewest edits (insert, delete, replace, swap of neighbours; case does not count),
// when it is near enough to be meant: at most a third of its length. The first one of equals.
std::optional<std::string> nearest_name(const std::string& written, std::span<const std::string> known);

// "did you mean `radius`? Known are: `radius`, `thickness`", without the question when nothing is near.
std::string name_hint(const std::string& written, std::span<const std::string> known);

}  // namespace gabarit
