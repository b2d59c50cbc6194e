// What `gabarit explain` prints, from the descriptors: plain text of at most 90 columns.
#pragma once

#include <string>

#include "rules/catalogue.h"
#include "rules/quantity.h"

namespace gabarit {

// The language in short, and every selector and measure with its summary.
std::string explain_all(const Catalogue& catalogue = {});

// One selector (all its variants) or measure: definition, parameters with their defaults, an example. Of an
// unknown name: the nearest one.
Result<std::string, Complaint> explain(const std::string& name, const Catalogue& catalogue = {});

// Lines of a rule file that the reader accepts.
std::string example(const Selector& selector);
std::string example(const Measure& measure);

}  // namespace gabarit
