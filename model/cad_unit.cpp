#include "model/cad_unit.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "model/text_encoding.h"

namespace gabarit {
namespace {

struct Word {
  const char* text;
  Unit unit;
};
constexpr std::array<Word, 13> words{{{"millimetre", Unit::mm},
                                      {"millimeter", Unit::mm},
                                      {"mm", Unit::mm},
                                      {"centimetre", Unit::cm},
                                      {"centimeter", Unit::cm},
                                      {"cm", Unit::cm},
                                      {"metre", Unit::m},
                                      {"meter", Unit::m},
                                      {"m", Unit::m},
                                      {"inch", Unit::in},
                                      {"inches", Unit::in},
                                      {"in", Unit::in},
                                      {"inc", Unit::in}}};

std::string plain(const std::string& text) {
  std::string word;
  for (const unsigned char c : text) {
    if (std::isalpha(c) != 0) word += static_cast<char>(std::tolower(c));
  }
  return word;
}

std::optional<Unit> known(const std::string& text) {
  const std::string word = plain(text);
  for (const Word& w : words) {
    if (word == w.text) return w.unit;
  }
  return std::nullopt;
}

}  // namespace

void set_declared_unit(std::span<const std::string> names, const std::string& file,
                       const LoadOptions& options, Model& model) {
  const auto warn = [&](std::string message) {
    model.warnings.push_back(
        {.level = Diagnostic::Level::warning, .file = file, .message = std::move(message)});
  };
  std::string listed;
  std::optional<Unit> unit;
  for (const std::string& text : names) {
    listed += (listed.empty() ? "" : ", ") + valid_utf8(text);
    if (!unit) unit = known(text);
  }
  model.unit = unit.value_or(Unit::mm);
  model.unit_declared = !names.empty();
  if (names.empty()) return warn("declares no unit of length; millimetres are assumed");
  if (!unit) return warn(fmt::format("its unit, {}, is converted to millimetres", listed));
  const auto lengths =
      std::count_if(names.begin(), names.end(), [](const std::string& n) { return known(n).has_value(); });
  if (lengths > 1) warn(fmt::format("has several units ({}); each part is read in its own", listed));
  if (options.unit && *options.unit != *unit)
    warn(fmt::format("declares the unit {}; --units {} is ignored", listed, name(*options.unit)));
}

}  // namespace gabarit
