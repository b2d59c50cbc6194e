// The selectors and measures that rule files may name.
#pragma once

#include "checks/check.h"

namespace gabarit {

struct Catalogue {
  std::span<const Selector* const> selectors = all_selectors();
  std::span<const Measure* const> measures = all_measures();

  // Several selectors may share a name; their variants tell them apart.
  std::vector<const Selector*> selectors_named(const std::string& name) const;
  const Measure* measure_named(const std::string& name) const;  // null: unknown
  std::vector<std::string> selector_names() const;              // each once
  std::vector<std::string> measure_names() const;
};

}  // namespace gabarit
