// Runs every rule of every rule set on a model.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "rules/outcome.h"

namespace gabarit {

struct EngineOptions {
  Device device;
  std::optional<double> sag;      // overrides the rule files' and the model's
  std::vector<std::string> only;  // rule ids; empty: all. The others are not planned.
  std::function<void(const std::string& rule, double fraction)> progress;  // may be empty
};

// A rule that throws becomes not_run with the reason; the others still run. An empty region is
// not_applicable.
Outcome run(const Model& model, std::vector<RuleSet> rulesets, const EngineOptions& options = {});

}  // namespace gabarit
