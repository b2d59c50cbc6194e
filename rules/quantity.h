// Quantities as users write them: "4 mm", "0.5mm", "30 deg", "2 cm2".
#pragma once

#include <string>

#include "checks/arguments.h"
#include "model/result.h"

namespace gabarit {

// What is wrong with a value, and what would be right.
struct Complaint {
  std::string message, hint;
};

// In mm, mm² or rad; numbers and counts have no unit. Only decimal numbers: no hexadecimal, infinity or NaN,
// whatever the locale.
Result<double, Complaint> read_quantity(const std::string& text, Dimension dimension);

// The shortest text that reads back as the same value: "4 mm", "2.5 mm2", "30 deg". An angle is rounded to
// 1e-9 deg.
std::string quantity_text(double value, Dimension dimension);

}  // namespace gabarit
