#include "model/number_word.h"

#include <charconv>
#include <cstdlib>
#include <limits>
#include <string>

namespace gabarit {

// "1.#INF", "-1.#IND", "1.#QNAN", "1.#SNAN", some with digits behind.
static bool read_windows_spelling(std::string_view word, double& value) {
  const bool negative = word.starts_with('-');
  if (negative) word.remove_prefix(1);
  if (!word.starts_with("1.#")) return false;
  word.remove_prefix(3);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (word.starts_with("INF")) return value = negative ? -infinity : infinity, true;
  if (!word.starts_with("IND") && !word.starts_with("QNAN") && !word.starts_with("SNAN")) return false;
  return value = std::numeric_limits<double>::quiet_NaN(), true;
}

static std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

bool read_number(std::string_view word, double& value) {
  word = without_plus(word);
  const char* const last = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data(), last, value);
  if (word.empty() || end != last) return read_windows_spelling(word, value);
  // from_chars does not say on which side the number is out of range; strtod does.
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(word).c_str(), nullptr);
  return true;
}

bool read_integer(std::string_view word, std::int64_t& value) {
  word = without_plus(word);
  const char* const last = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data(), last, value);
  return !word.empty() && error == std::errc{} && end == last;
}

}  // namespace gabarit
