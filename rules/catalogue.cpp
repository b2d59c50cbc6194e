#include "rules/catalogue.h"

#include <algorithm>

namespace gabarit {

std::vector<const Selector*> Catalogue::selectors_named(const std::string& name) const {
  std::vector<const Selector*> found;
  for (const Selector* selector : selectors) {
    if (selector->name == name) found.push_back(selector);
  }
  return found;
}

const Measure* Catalogue::measure_named(const std::string& name) const {
  const auto found = std::find_if(measures.begin(), measures.end(),
                                  [&](const Measure* measure) { return measure->name == name; });
  return found == measures.end() ? nullptr : *found;
}

std::vector<std::string> Catalogue::selector_names() const {
  std::vector<std::string> names;
  for (const Selector* selector : selectors) {
    if (std::find(names.begin(), names.end(), selector->name) == names.end()) names.push_back(selector->name);
  }
  return names;
}

std::vector<std::string> Catalogue::measure_names() const {
  std::vector<std::string> names;
  for (const Measure* measure : measures) names.push_back(measure->name);
  return names;
}

}  // namespace gabarit
