#include "rules/read_requirement.h"

#include <array>
#include <limits>

#include <fmt/format.h>

#include "rules/nearest_name.h"
#include "rules/read_arguments.h"
#include "rules/read_value.h"

namespace gabarit {

namespace {

struct LimitNodes {
  const YamlNode* at_least;
  const YamlNode* at_most;
  const YamlNode* between;
};

// NaN after a complaint.
double limit_value(RuleText& text, const YamlNode& node, Dimension dimension) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (node.kind != YamlNode::Kind::scalar) {
    text.error(node, "a limit is one value");
    return none;
  }
  const auto value = read_quantity(node.text, dimension);
  if (value) return *value;
  text.error(node, value.error().message, value.error().hint);
  return none;
}

// Lengths and areas are never negative: such a limit would say nothing and pass everything.
bool bounds_only(Dimension dimension) {
  return dimension == Dimension::length || dimension == Dimension::area;
}

void check_not_empty(RuleText& text, const YamlNode& node, double value, Dimension dimension, bool floor) {
  if (!bounds_only(dimension)) return;
  if (floor && value <= 0)
    text.error(node, fmt::format("every value is at least `{}`", node.text), "a limit is above 0");
  if (!floor && value < 0)
    text.error(node, fmt::format("no value is at most `{}`", node.text), "a limit is not negative");
}

void read_between(RuleText& text, const YamlNode& node, Dimension dimension, Requirement& require) {
  if (node.kind != YamlNode::Kind::list || node.items.size() != 2) {
    text.error(node, "`between` is a list of two limits", "such as `between: [1 mm, 3 mm]`");
    return;
  }
  Limit& limit = require.limit;
  limit = {.kind = Limit::Kind::between,
           .low = limit_value(text, node.items[0], dimension),
           .high = limit_value(text, node.items[1], dimension)};
  if (limit.low > limit.high) {
    text.error(node, fmt::format("nothing is between `{}` and `{}`", node.items[0].text, node.items[1].text),
               "the smaller limit comes first");
  }
  if (bounds_only(dimension) && limit.high < 0) text.error(node, "no value is negative");
  require.limit_text = fmt::format("between {} and {}", node.items[0].text, node.items[1].text);
}

void read_one_sided(RuleText& text, const YamlNode& node, Dimension dimension, bool floor,
                    Requirement& require) {
  const double value = limit_value(text, node, dimension);
  require.limit = {.kind = floor ? Limit::Kind::at_least : Limit::Kind::at_most,
                   .low = floor ? value : 0,
                   .high = floor ? 0 : value};
  require.limit_text = fmt::format("{} {}", floor ? "at least" : "at most", node.text);
  check_not_empty(text, node, value, dimension, floor);
}

void read_limit(RuleText& text, const YamlEntry& entry, const LimitNodes& nodes, Requirement& require) {
  const Dimension dimension = require.measure->dimension;
  const int count = (nodes.at_least ? 1 : 0) + (nodes.at_most ? 1 : 0) + (nodes.between ? 1 : 0);
  if (count == 0) {
    text.error(entry.key, fmt::format("`{}` has no limit", entry.key.text),
               "give one of `at least`, `at most` and `between`");
  } else if (count > 1) {
    if (nodes.at_least) limit_value(text, *nodes.at_least, dimension);
    if (nodes.at_most) limit_value(text, *nodes.at_most, dimension);
    text.error(
        entry.key, fmt::format("`{}` has several limits", entry.key.text),
        nodes.between ? "one limit a rule; write a second rule" : "write `between: [smallest, greatest]`");
  } else if (nodes.between) {
    read_between(text, *nodes.between, dimension, require);
  } else {
    read_one_sided(text, nodes.at_least ? *nodes.at_least : *nodes.at_most, dimension,
                   nodes.at_least != nullptr, require);
  }
}

}  // namespace

Requirement read_requirement(RuleText& text, const YamlNode& node, const Catalogue& catalogue) {
  Requirement require;
  if (node.kind != YamlNode::Kind::map || node.entries.size() != 1) {
    text.error(node, "`require` is one measure with its limit",
               "such as `radius: {at least: 4 mm}`; what else is required is another rule");
    return require;
  }
  const YamlEntry& entry = node.entries.front();
  const std::string& name = entry.key.text;
  require.measure = catalogue.measure_named(name);
  if (!require.measure) {
    text.error(entry.key, fmt::format("unknown measure `{}`", name),
               name_hint(name, catalogue.measure_names()));
    return require;
  }
  if (entry.value.kind != YamlNode::Kind::map) {
    text.error(entry.value, fmt::format("`{}` has no limit", name),
               fmt::format("write `{}: {{at least: …}}`", name));
    return require;
  }
  KeyedMap map(text, entry.value, fmt::format("`{}`", name));
  const LimitNodes limits{map.optional("at least"), map.optional("at most"), map.optional("between")};
  require.arguments = read_arguments(text, require.measure->parameters, map, entry.key, name);
  read_limit(text, entry, limits, require);
  map.refuse_others();
  return require;
}

}  // namespace gabarit
