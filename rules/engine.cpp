#include "rules/engine.h"

#include <algorithm>
#include <new>
#include <stdexcept>

#include "rules/judge_field.h"
#include "rules/region.h"
#include "rules/setup.h"
#include "rules/totals.h"
#include "rules/verdict.h"

namespace gabarit {

namespace {

struct Run {
  const Scene* scene;
  const EngineOptions* options;
  Outcome outcome;
};

bool planned(const Rule& rule, const std::vector<std::string>& only) {
  return only.empty() || std::find(only.begin(), only.end(), rule.id) != only.end();
}

// Selecting is reported as the first half of a rule and measuring as the second, never going back.
Setup with_progress(Setup setup, const EngineOptions& options, const std::string& rule, double& highest,
                    double from) {
  if (!options.progress) return setup;
  setup.progress = [&options, &rule, &highest, from](double fraction) {
    highest = std::max(highest, from + 0.5 * std::clamp(fraction, 0.0, 1.0));
    options.progress(rule, highest);
  };
  return setup;
}

// An earlier rule of the same set that looks at the same facets; rule sets often hold one contact with
// several limits.
const RuleResult* earlier(const Outcome& outcome, const RuleResult& result) {
  for (const RuleResult& other : outcome.results) {
    if (other.ruleset == result.ruleset && other.verdict != Verdict::not_run &&
        same(other.rule.where, result.rule.where)) {
      return &other;
    }
  }
  return nullptr;
}

bool same_limit(const Limit& a, const Limit& b) {
  return a.kind == b.kind && a.low == b.low && a.high == b.high;
}

bool measures_the_same(const RuleResult& a, const RuleResult& b) {
  return a.rule.require.measure == b.rule.require.measure &&
         a.rule.require.arguments.all() == b.rule.require.arguments.all() &&
         (!a.rule.require.measure->varies_within_facets ||
          same_limit(a.rule.require.limit, b.rule.require.limit));
}

// What a measure has to know of the limit: which value of a facet decides, and how finely to look.
Setup asked_by(Setup setup, const Limit& limit, Extreme extreme) {
  setup.extreme = extreme;
  setup.limit = extreme == Extreme::smallest ? limit.low : limit.high;
  // Between two places the smallest value is bounded, the greatest only estimated: it is looked for more
  // finely.
  setup.resolution = extreme == Extreme::smallest ? limit.low / 2 : limit.high / 16;
  return setup;
}

// Of `between`, facets that break or may break the upper limit take their greatest value.
void take_greatest(const Limit& limit, Field& field, const Field& greatest) {
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Limit low{.kind = Limit::Kind::at_least, .low = limit.low};
    const Limit high{.kind = Limit::Kind::at_most, .high = limit.high};
    const FacetVerdict below = judge(field.lower[i], field.upper[i], low, Selected::yes);
    const FacetVerdict above = judge(greatest.lower[i], greatest.upper[i], high, Selected::yes);
    const bool worse = above == FacetVerdict::fail
                           ? below != FacetVerdict::fail
                           : above == FacetVerdict::undecided && below == FacetVerdict::pass;
    if (!worse) continue;
    field.value[i] = greatest.value[i];
    field.lower[i] = greatest.lower[i];
    field.upper[i] = greatest.upper[i];
    field.at[i] = greatest.at[i];
    field.contact[i] = greatest.contact[i];
    field.absence[i] = greatest.absence[i];
  }
}

bool selects_nothing(const Region& region) {
  return std::all_of(region.facets.begin(), region.facets.end(),
                     [](Selected s) { return s == Selected::no; });
}

void examine(Run& run, RuleResult& result) {
  const Setup& setup = run.outcome.setups[result.ruleset];
  const Requirement& require = result.rule.require;
  double highest = 0;
  const RuleResult* before = earlier(run.outcome, result);
  result.region = before
                      ? before->region
                      : select(*run.scene, with_progress(setup, *run.options, result.rule.id, highest, 0.0),
                               result.rule.where);
  if (before && measures_the_same(*before, result)) {
    result.field = before->field;
  } else if (!selects_nothing(result.region)) {
    const Setup half = with_progress(setup, *run.options, result.rule.id, highest, 0.5);
    const Limit& limit = require.limit;
    const auto field = [&](Extreme extreme) {
      return require.measure->measure(*run.scene, asked_by(half, limit, extreme), result.region,
                                      require.arguments);
    };
    result.field = field(limit.kind == Limit::Kind::at_most ? Extreme::greatest : Extreme::smallest);
    if (limit.kind == Limit::Kind::between && require.measure->varies_within_facets)
      take_greatest(limit, result.field, field(Extreme::greatest));
  }
  judge_field(run.scene->model(), result);
}

RuleResult fresh(const Rule& rule, std::size_t ruleset) {
  RuleResult result;
  result.rule = rule;
  result.ruleset = ruleset;
  return result;
}

// The rule's result says that it was not run unless it was run to the end: no half of a result survives.
RuleResult not_run(const Rule& rule, std::size_t ruleset, std::string reason) {
  RuleResult result = fresh(rule, ruleset);
  result.reason = std::move(reason);
  return result;
}

RuleResult attempt(Run& run, const Rule& rule, std::size_t ruleset) {
  try {
    RuleResult result = fresh(rule, ruleset);
    examine(run, result);
    return result;
  } catch (const std::bad_alloc&) {
    return not_run(rule, ruleset, "There was not enough memory.");
  } catch (const std::exception& error) {
    return not_run(rule, ruleset, std::string("The check stopped: ") + error.what() + ".");
  } catch (...) {
    return not_run(rule, ruleset, "The check stopped for an unknown reason.");
  }
}

}  // namespace

Outcome run(const Model& model, std::vector<RuleSet> rulesets, const EngineOptions& options) {
  const Scene scene(model, options.device);
  Run run{.scene = &scene, .options = &options, .outcome = {}};
  Outcome& outcome = run.outcome;
  outcome.device = options.device.kind == Device::Kind::cuda ? "cuda" : "cpu";
  for (std::size_t i = 0; i < rulesets.size(); ++i) {
    outcome.setups.push_back(resolve_setup(model, rulesets[i], options.sag));
    for (const Rule& rule : rulesets[i].rules) {
      if (!planned(rule, options.only)) continue;
      if (options.progress) options.progress(rule.id, 0.0);
      outcome.results.push_back(attempt(run, rule, i));
      if (options.progress) options.progress(rule.id, 1.0);
    }
  }
  outcome.rulesets = std::move(rulesets);
  outcome.totals = count(outcome.results);
  outcome.verdict = overall(outcome.results);
  return std::move(run.outcome);
}

}  // namespace gabarit
