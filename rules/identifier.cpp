#include "rules/identifier.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace gabarit {

std::string identifier_key(std::string id) {
  for (char& c : id) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return id;
}

static bool is_reserved(const std::string& id) {
  const std::string key = identifier_key(id);
  const std::string_view stem = std::string_view(key).substr(0, key.find('.'));
  constexpr std::array<std::string_view, 4> devices{"con", "prn", "aux", "nul"};
  if (std::find(devices.begin(), devices.end(), stem) != devices.end()) return true;
  return stem.size() == 4 && (stem.starts_with("com") || stem.starts_with("lpt")) && stem[3] >= '0' &&
         stem[3] <= '9';
}

std::optional<std::string> fault_of_identifier(const std::string& id) {
  constexpr std::size_t longest = 64;
  const bool plain = std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '_' || c == '-';
  });
  if (!plain) return "an id has only letters, digits, `.`, `_` and `-`: it names files";
  if (id.size() > longest) return "an id has at most 64 characters: it names files";
  if (id.starts_with('.') || id.starts_with('-'))
    return "an id does not begin with `.` or `-`: it names files";
  if (id.ends_with('.')) return "an id does not end with `.`: it names files";
  if (is_reserved(id)) return "this id is a reserved name of some file systems";
  return std::nullopt;
}

}  // namespace gabarit
