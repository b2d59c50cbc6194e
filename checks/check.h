// A selector says where a rule looks, a measure says what it measures there. Each is one constant descriptor
// that the rule reader, `gabarit explain`, the schema of rule files and the documentation read.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "checks/arguments.h"
#include "checks/field.h"
#include "checks/region.h"
#include "checks/scene.h"

namespace gabarit {

struct Selector {
  std::string name;  // the key in a rule file, such as "contact"
  // The value of its first parameter that picks this one, such as "vertical cylinder"; may be empty.
  std::string variant = {};
  std::string summary;                // one sentence
  std::string documentation;          // definition, limits, source; paragraphs separated by empty lines
  std::vector<Parameter> parameters;  // the first may be given alone: `body: "tank"`
  Region (*select)(const Scene&, const Setup&, const Arguments&);
  // Of selectors that limit heights: the band they leave, which contacts beside them (in the same `all`) use.
  Interval (*height_band)(const Arguments&) = nullptr;
  // A sentence for the report, with the values: "a vertical cylinder of 300 mm diameter can touch it in
  // forward motion".
  std::string (*sentence)(const Arguments&) = nullptr;
};

struct Measure {
  std::string name;  // the key in a rule file, such as "radius"
  std::string summary;
  std::string documentation;
  std::string symbol;  // in tables and legends, such as "R" or "t"
  Dimension dimension = Dimension::length;
  std::vector<Parameter> parameters = {};  // all named; the limit is not among them
  Field (*measure)(const Scene&, const Setup&, const Region&, const Arguments&);
  // Whether a facet can have several values, so that the extreme and the resolution of the setup matter.
  bool varies_within_facets = false;
  std::string (*sentence)(const Arguments&) = nullptr;
};

// In the order of the documentation. A new one is a file and a line in all_checks.cpp.
std::span<const Selector* const> all_selectors();
std::span<const Measure* const> all_measures();

// What a rule without `where` looks at.
Region whole_model(const TriangleMesh& mesh);

}  // namespace gabarit
