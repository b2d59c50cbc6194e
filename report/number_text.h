// Numbers for people: few digits, but never so few that the text contradicts the comparison it stands for.
#pragma once

#include <string>

namespace gabarit {

// At least four significant digits, and as many more as it takes to tell the value from the limit: 0.79996
// against 0.8 is "0.79996", not "0.8000". "unknown" for NaN, "unlimited" for infinity.
std::string number_text(double value, double limit);
std::string number_text(double value);

}  // namespace gabarit
