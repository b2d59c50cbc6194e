#include "report/number_text.h"

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace gabarit {

static int order(double a, double b) { return a < b ? -1 : a > b ? 1 : 0; }

std::string number_text(double value, double limit) {
  if (std::isnan(value)) return "unknown";
  if (std::isinf(value)) return value < 0 ? "-unlimited" : "unlimited";
  std::string text;
  for (int digits = 4; digits <= 17; ++digits) {
    text = fmt::format("{:.{}g}", value, digits);
    if (order(std::strtod(text.c_str(), nullptr), limit) == order(value, limit)) break;
  }
  return text;
}

std::string number_text(double value) { return number_text(value, std::nan("")); }

}  // namespace gabarit
