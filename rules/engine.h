// Runs every rule of every rule set on a model.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "model/result.h"
#include "rules/outcome.h"

namespace gabarit {

struct EngineOptions {
  Device device = {};
  std::optional<double> sag = {};      // overrides the rule files' and the model's
  std::vector<std::string> only = {};  // rule ids; empty: all. The others are not planned.
  std::function<void(const std::string& rule, double fraction)> progress = {};  // may be empty
};

// What stands in the way of a run: an id of `only` that no rule has (with the nearest one), or a rule id that
// two rule sets share (ids name output files). Empty: nothing.
Diagnostics check_selection(std::span<const RuleSet> rulesets, std::span<const std::string> only);

// A rule that throws becomes not_run with the reason; the others still run. An empty region is
// not_applicable. Throws DeviceError when the device fails: what it computed before is not to be trusted.
// Expects check_selection() to have found nothing.
Outcome run(const Model& model, std::vector<RuleSet> rulesets, const EngineOptions& options = {});

}  // namespace gabarit
