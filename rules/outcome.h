// What a run found: one result a rule, planned or not run, and everything the reports show.
#pragma once

#include <string>
#include <vector>

#include "gpu/box.h"
#include "rules/verdict.h"

namespace gabarit {

struct Worst {
  double value = 0, lower = 0, upper = 0;  // NaN value: not known
  Vec3d at;                                // model coordinates, mm
  Vec3d contact;                           // the other end (see Field::contact)
  FacetId facet = 0;
};

// One connected patch of failing (or undecided) facets.
struct Finding {
  std::string id;  // "<rule>/<number>", numbered from 1, worst first
  Verdict verdict = Verdict::fail;
  std::vector<FacetId> facets;  // ascending
  double area = 0;              // mm²
  Worst worst;
  Vec3d centroid;  // weighted by area
  Box3d box;
  std::string body;           // of the worst facet; empty when a mesh is one body
  std::vector<FaceId> faces;  // that it lies on, ascending; none without exact surfaces
};

struct RuleResult {
  Rule rule;
  std::size_t ruleset = 0;  // index into Outcome::rulesets
  Verdict verdict = Verdict::not_run;
  std::string reason;  // why not applicable, not run or undecided; a whole sentence
  Region region;
  Field field;
  std::vector<FacetVerdict> facet_verdicts;  // one an entry of `field`
  std::size_t facets_examined = 0, facets_failed = 0, facets_undecided = 0;
  double area_examined = 0, area_failed = 0, area_undecided = 0;  // mm²
  std::vector<Finding> findings;     // fails, worst first, then undecided ones, worst first
  std::size_t findings_ignored = 0;  // smaller than Rule::ignore_area
  bool has_worst = false;
  Worst worst;  // over all examined facets
};

struct Totals {
  std::size_t planned = 0, passed = 0, failed = 0, undecided = 0, not_applicable = 0, not_run = 0, waived = 0;
};

struct Outcome {
  std::vector<RuleSet> rulesets;
  std::vector<Setup> setups;  // one a rule set: frame with the ground resolved, sag in force
  std::vector<RuleResult> results;
  Totals totals;
  Verdict verdict = Verdict::not_run;  // fail > not_run > undecided > pass > not_applicable
  std::string device;                  // what computed: "cpu" or "cuda"
};

}  // namespace gabarit
