#include "rules/schema.h"

#include <nlohmann/json.hpp>

namespace gabarit {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* number_pattern = "[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?";

Json reference(const char* name) { return {{"$ref", std::string("#/$defs/") + name}}; }

Json quantity(const char* units) {
  return {{"type", "string"}, {"pattern", std::string("^ *") + number_pattern + " *(" + units + ") *$"}};
}

Json list_of_three(Json item) {
  return {{"type", "array"}, {"items", std::move(item)}, {"minItems", 3}, {"maxItems", 3}};
}

Json object(Json properties, Json required) {
  Json schema{{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
  if (!required.empty()) schema["required"] = std::move(required);
  return schema;
}

Json either(Json a, Json b) { return {{"anyOf", Json::array({std::move(a), std::move(b)})}}; }

Json of_dimension(const Parameter& p) {
  switch (p.dimension) {
    case Dimension::length: return reference("length");
    case Dimension::area: return reference("area");
    case Dimension::angle: return reference("angle");
    case Dimension::number: return {{"type", "number"}};
    case Dimension::count: return {{"type", "integer"}, {"minimum", 0}};
    case Dimension::choice: return {{"enum", p.choices}};
    case Dimension::text: return {{"type", "string"}, {"minLength", 1}};
    case Dimension::point: return list_of_three(reference("length"));
    case Dimension::direction: break;
  }
  Json vector = list_of_three({{"type", "number"}});
  return p.choices.empty() ? vector : either({{"enum", p.choices}}, std::move(vector));
}

Json of_parameter(const Parameter& p) {
  Json schema = of_dimension(p);
  schema["description"] = p.documentation;
  if (p.default_text) schema["default"] = *p.default_text;
  return schema;
}

bool must_be_given(const Parameter& p) { return !p.optional && !p.default_text; }

Json of_selector(const Selector& selector) {
  Json properties = Json::object(), required = Json::array();
  bool first_is_enough = !selector.parameters.empty();
  for (const Parameter& p : selector.parameters) {
    const bool first = &p == &selector.parameters.front();
    properties[p.name] = of_parameter(p);
    if (first && !selector.variant.empty()) properties[p.name]["enum"] = Json::array({selector.variant});
    if (must_be_given(p)) required.push_back(p.name);
    first_is_enough = first_is_enough && (first || !must_be_given(p));
  }
  Json map = object(std::move(properties), std::move(required));
  if (selector.parameters.empty() || !first_is_enough) return map;
  return either(std::move(map), of_parameter(selector.parameters.front()));
}

Json one_key(const std::string& key, Json value) {
  return object({{key, std::move(value)}}, Json::array({key}));
}

Json where_schema(const Catalogue& catalogue) {
  const Json list{{"type", "array"}, {"items", reference("where")}, {"minItems", 1}};
  Json forms = Json::array({one_key("all", list), one_key("any", list), one_key("not", reference("where"))});
  for (const Selector* selector : catalogue.selectors) {
    Json form = one_key(selector->name, of_selector(*selector));
    form["description"] = selector->summary;
    forms.push_back(std::move(form));
  }
  return {{"anyOf", std::move(forms)}};
}

Json measure_schema(const Measure& measure) {
  const Json limit = of_dimension({.name = {}, .dimension = measure.dimension, .documentation = {}});
  Json properties{{"at least", limit},
                  {"at most", limit},
                  {"between", {{"type", "array"}, {"items", limit}, {"minItems", 2}, {"maxItems", 2}}}};
  Json required = Json::array();
  for (const Parameter& p : measure.parameters) {
    properties[p.name] = of_parameter(p);
    if (must_be_given(p)) required.push_back(p.name);
  }
  Json schema = object(std::move(properties), std::move(required));
  schema["oneOf"] = Json::array();
  for (const char* key : {"at least", "at most", "between"}) {
    schema["oneOf"].push_back({{"required", Json::array({key})}});
  }
  return schema;
}

Json require_schema(const Catalogue& catalogue) {
  Json forms = Json::array();
  for (const Measure* measure : catalogue.measures) {
    Json form = one_key(measure->name, measure_schema(*measure));
    form["description"] = measure->summary;
    forms.push_back(std::move(form));
  }
  return {{"anyOf", std::move(forms)}};
}

// Text that YAML may read as a number, such as `clause: 2.1`.
Json line() { return {{"type", Json::array({"string", "number", "boolean"})}}; }

Json identifier() { return {{"type", "string"}, {"pattern", "^[A-Za-z0-9_][A-Za-z0-9._-]{0,63}$"}}; }

Json rule_schema(const Catalogue& catalogue) {
  return object({{"id", identifier()},
                 {"title", line()},
                 {"clause", line()},
                 {"severity", {{"enum", {"error", "warning", "note"}}}},
                 {"where", reference("where")},
                 {"require", require_schema(catalogue)},
                 {"ignore", one_key("regions under", reference("area"))}},
                Json::array({"id", "require"}));
}

Json frame_schema() {
  const Json axis{{"enum", {"+x", "-x", "+y", "-y", "+z", "-z"}}};
  return object(
      {{"up", axis}, {"forward", axis}, {"ground", either({{"const", "lowest"}}, reference("length"))}},
      Json::array());
}

Json definitions(const Catalogue& catalogue) {
  return {{"length", quantity("mm|cm|m|in")},
          {"area", quantity("mm2|cm2|m2|in2|mm²|cm²|m²")},
          {"angle", quantity("deg|rad")},
          {"where", where_schema(catalogue)},
          {"rule", rule_schema(catalogue)}};
}

}  // namespace

std::string rules_schema(const Catalogue& catalogue) {
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "Gabarit rule file"}};
  const Json source =
      object({{"document", line()}, {"edition", line()}, {"address", line()}, {"status", line()}},
             Json::array({"document"}));
  const Json rules{{"type", "array"}, {"items", reference("rule")}, {"minItems", 1}};
  schema.update(object({{"gabarit", {{"const", 1}}},
                        {"id", identifier()},
                        {"title", line()},
                        {"revision", line()},
                        {"source", source},
                        {"frame", frame_schema()},
                        {"sag", reference("length")},
                        {"rules", rules}},
                       Json::array({"gabarit", "id", "rules"})));
  schema["$defs"] = definitions(catalogue);
  return schema.dump(2) + "\n";
}

}  // namespace gabarit
