#include "rules/read_header.h"

#include <fmt/format.h>

#include "rules/identifier.h"
#include "rules/nearest_name.h"
#include "rules/quantity.h"

namespace gabarit {

namespace {

const std::vector<std::string> axes{"+x", "-x", "+y", "-y", "+z", "-z"};

Vec3d axis_named(const std::string& name) {
  Vec3d axis;
  axis[name[1] - 'x'] = name[0] == '-' ? -1.0 : 1.0;
  return axis;
}

void read_axis(RuleText& text, KeyedMap& frame, const std::string& key, Vec3d& axis) {
  const YamlNode* node = frame.optional(key);
  if (!node) return;
  for (const std::string& name : axes) {
    if (node->text != name) continue;
    axis = axis_named(name);
    return;
  }
  const std::string signed_name = "+" + node->text;
  text.error(*node, fmt::format("`{}` is not an axis", node->text), name_hint(signed_name, axes));
}

// Nothing after a complaint.
std::optional<double> read_length(RuleText& text, const YamlNode& node, const std::string& key) {
  if (node.kind != YamlNode::Kind::scalar) {
    text.error(node, fmt::format("`{}` is a length", key));
    return std::nullopt;
  }
  const auto value = read_quantity(node.text, Dimension::length);
  if (value) return *value;
  text.error(node, value.error().message, value.error().hint);
  return std::nullopt;
}

void read_ground(RuleText& text, const YamlNode& node, RuleSet& rules) {
  if (node.kind == YamlNode::Kind::scalar && node.text == "lowest") {
    rules.ground = Ground::lowest;
    return;
  }
  if (node.kind == YamlNode::Kind::scalar && node.text.find_first_of("0123456789") == std::string::npos) {
    text.error(node, fmt::format("unknown ground `{}`", node.text),
               "`lowest` (the lowest vertex) or a height such as `0 mm`");
    return;
  }
  rules.ground = Ground::height;
  rules.ground_height = read_length(text, node, "ground").value_or(0);
}

void read_frame(RuleText& text, const YamlNode& node, RuleSet& rules) {
  KeyedMap frame(text, node, "`frame`");
  read_axis(text, frame, "up", rules.up);
  read_axis(text, frame, "forward", rules.forward);
  if (dot(rules.up, rules.forward) != 0) {
    text.error(node, "`up` and `forward` lie along the same axis", "they are at right angles");
  }
  if (const YamlNode* ground = frame.optional("ground")) read_ground(text, *ground, rules);
  frame.refuse_others();
}

void read_source(RuleText& text, const YamlNode& node, Source& source) {
  KeyedMap map(text, node, "`source`");
  source.document = map.required_line("document");
  source.edition = map.line("edition");
  source.address = map.line("address");
  source.status = map.line("status");
  map.refuse_others();
}

}  // namespace

std::string read_identifier(RuleText& text, KeyedMap& map) {
  std::string id = map.required_line("id");
  if (id.empty()) return id;
  if (const auto fault = fault_of_identifier(id)) {
    text.error(*map.optional("id"), fmt::format("`{}` can't be an id", id), *fault);
  }
  return id;
}

void read_header(RuleText& text, KeyedMap& map, RuleSet& rules) {
  rules.id = read_identifier(text, map);
  rules.title = map.line("title");
  if (rules.title.empty()) rules.title = rules.id;
  rules.revision = map.line("revision");
  if (const YamlNode* source = map.optional("source")) read_source(text, *source, rules.source);
  if (const YamlNode* frame = map.optional("frame")) read_frame(text, *frame, rules);
  const YamlNode* sag = map.optional("sag");
  if (!sag) return;
  rules.sag = read_length(text, *sag, "sag");
  if (rules.sag && *rules.sag <= 0) {
    text.error(*sag, fmt::format("a sag of `{}` would claim that the facets are the true surface", sag->text),
               "`sag` is the largest distance between them, above 0");
  }
}

}  // namespace gabarit
