// A JSON Schema of rule files, for editors that check YAML while it is written.
#pragma once

#include <string>

#include "rules/catalogue.h"

namespace gabarit {

// Draft 2020-12, indented, ends with a line end. It knows every key, name, choice and unit; contradictions
// between values are left to the reader.
std::string rules_schema(const Catalogue& catalogue = {});

}  // namespace gabarit
