// Short texts of numbers and places for tables and entries.
#pragma once

#include <string>

#include "rules/outcome.h"

namespace gabarit::pdf {

// "440 312", grouped by narrow spaces from five digits on.
std::string grouped(std::string digits);
std::string count_text(std::size_t count);
// "1 facet", "12 facets".
std::string counted(std::size_t count, const std::string& noun);
// "(12.0, 3.5, 800.0)"; "unknown" when it is not finite.
std::string place_text(const Vec3d& place);
// "mm", "mm²", "°" or nothing.
std::string unit_text(const Requirement& require);
// "2.013 mm".
std::string measured_text(double value, const Requirement& require);
// "2.001 to 2.024".
std::string bounds_text(const Worst& worst, const Requirement& require);
// "12.5", whole numbers from 1000 on; with its unit: "12.5 mm²".
std::string area_number(double area);
std::string area_text(double area);
std::string length_text(double length);  // "0.1 mm"
// What a verdict says about the whole, in a sentence.
std::string overall_sentence(const Outcome& outcome);
// "2 rules planned: 1 failed, 0 not run, …".
std::string totals_sentence(const Totals& totals);
const char* severity_word(Severity severity);
// The name of the measure and its symbol: "radius R".
std::string measure_text(const Requirement& require);

}  // namespace gabarit::pdf
