#include "rules/nearest_name.h"

#include <algorithm>

#include <fmt/format.h>

namespace gabarit {

static std::string lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

// Optimal string alignment distance (Damerau 1964, with neighbours swapped at most once).
static std::size_t edits(const std::string& a, const std::string& b) {
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> d((a.size() + 1) * width);
  for (std::size_t i = 0; i <= a.size(); ++i) d[i * width] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = d[(i - 1) * width + j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U);
      std::size_t best = std::min({replaced, d[(i - 1) * width + j] + 1, d[i * width + j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        best = std::min(best, d[(i - 2) * width + j - 2] + 1);
      }
      d[i * width + j] = best;
    }
  }
  return d.back();
}

std::optional<std::string> nearest_name(const std::string& written, std::span<const std::string> known) {
  constexpr std::size_t longest = 64;  // nobody mistypes more, and the table stays small
  std::optional<std::string> nearest;
  std::size_t fewest = 0;
  if (written.size() > longest) return nearest;
  for (const std::string& name : known) {
    const std::size_t n = edits(lower_case(written), lower_case(name));
    const std::size_t allowed = std::max<std::size_t>(1, std::max(name.size(), written.size()) / 3);
    if (n <= allowed && (!nearest || n < fewest)) {
      nearest = name;
      fewest = n;
    }
  }
  return nearest;
}

std::string name_hint(const std::string& written, std::span<const std::string> known) {
  std::string text;
  if (const auto nearest = nearest_name(written, known)) text = fmt::format("did you mean `{}`? ", *nearest);
  if (known.empty()) return text + "none is known";
  text += known.size() == 1 ? "the only one known is " : "known are: ";
  for (const std::string& name : known)
    text += fmt::format("{}`{}`", &name == &known.front() ? "" : ", ", name);
  return text;
}

}  // namespace gabarit
