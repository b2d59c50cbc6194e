#include "rules/read_arguments.h"

#include <algorithm>

#include <fmt/format.h>

#include "rules/read_value.h"

namespace gabarit {

namespace {

const Parameter* parameter_named(std::span<const Parameter> parameters, const std::string& name) {
  const auto found =
      std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& p) { return p.name == name; });
  return found == parameters.end() ? nullptr : &*found;
}

// A list is handed on as it would be written in one line; its parts are checked there.
std::string written(const YamlNode& node) {
  if (node.kind == YamlNode::Kind::scalar) return node.text;
  std::string text;
  for (const YamlNode& item : node.items) {
    text += (text.empty() ? "" : ", ") + (item.kind == YamlNode::Kind::scalar ? item.text : std::string("?"));
  }
  return "[" + text + "]";
}

bool is_list_of(Dimension dimension) {
  return dimension == Dimension::point || dimension == Dimension::direction;
}

bool ends_before_it_begins(const Value& from, const Value& to) {
  if (const Vec3d* a = std::get_if<Vec3d>(&from)) {
    const Vec3d& b = std::get<Vec3d>(to);
    return a->x > b.x || a->y > b.y || a->z > b.z;
  }
  return std::holds_alternative<double>(from) && std::get<double>(from) > std::get<double>(to);
}

void check_range(RuleText& text, std::span<const Parameter> parameters, const YamlNode& at,
                 const std::string& name, const Arguments& arguments) {
  const Parameter* from = parameter_named(parameters, "from");
  const Parameter* to = parameter_named(parameters, "to");
  if (!from || !to || from->dimension != to->dimension) return;
  if (!arguments.has("from") || !arguments.has("to")) return;
  if (ends_before_it_begins(arguments.all().at("from"), arguments.all().at("to"))) {
    text.error(at, fmt::format("the range of `{}` ends before it begins", name), "`from` is not above `to`");
  }
}

std::string quoted_list(std::span<const Parameter> parameters) {
  std::string names;
  for (const Parameter& p : parameters) names += fmt::format("{}`{}`", names.empty() ? "" : ", ", p.name);
  return names;
}

void read_argument(RuleText& text, const Parameter& parameter, const YamlNode& node, Arguments& arguments) {
  const bool list = node.kind == YamlNode::Kind::list;
  if (node.kind == YamlNode::Kind::null) {
    text.error(node, fmt::format("`{}` has no value", parameter.name));
  } else if (node.kind == YamlNode::Kind::map || (list && !is_list_of(parameter.dimension))) {
    text.error(node, fmt::format("`{}` is one value", parameter.name));
  } else if (const auto value = read_value(parameter, written(node))) {
    arguments.set(parameter.name, *value);
  } else {
    text.error(node, value.error().message, value.error().hint);
  }
}

// `given` names the parameters that the file speaks of: a wrong value is not also a missing one.
void complete(RuleText& text, std::span<const Parameter> parameters, const YamlNode& at,
              const std::string& name, const std::vector<std::string>& given, Arguments& arguments) {
  const bool all_optional = !parameters.empty() && std::all_of(parameters.begin(), parameters.end(),
                                                               [](const Parameter& p) { return p.optional; });
  if (all_optional && given.empty()) {
    text.error(at, fmt::format("`{}` needs at least one of {}", name, quoted_list(parameters)));
  }
  for (const std::string& missing : fill_defaults(parameters, arguments)) {
    if (std::find(given.begin(), given.end(), missing) != given.end()) continue;
    text.error(at, fmt::format("`{}` needs `{}`", name, missing),
               parameter_named(parameters, missing)->documentation);
  }
  check_range(text, parameters, at, name, arguments);
}

}  // namespace

Arguments read_arguments(RuleText& text, std::span<const Parameter> parameters, KeyedMap& map,
                         const YamlNode& at, const std::string& name) {
  Arguments arguments;
  std::vector<std::string> given;
  for (const Parameter& parameter : parameters) {
    const YamlNode* node = map.optional(parameter.name);
    if (!node) continue;
    read_argument(text, parameter, *node, arguments);
    given.push_back(parameter.name);
  }
  complete(text, parameters, at, name, given, arguments);
  return arguments;
}

Arguments read_shorthand(RuleText& text, std::span<const Parameter> parameters, const YamlNode& value,
                         const YamlNode& at, const std::string& name) {
  Arguments arguments;
  if (parameters.empty()) {
    text.error(value, fmt::format("`{}` has no parameters", name), "write `" + name + ": {}`");
    return arguments;
  }
  read_argument(text, parameters.front(), value, arguments);
  complete(text, parameters, at, name, {parameters.front().name}, arguments);
  return arguments;
}

}  // namespace gabarit
