#include "rules/read_rules.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>

#include <fmt/format.h>

#include "model/sha256.h"
#include "rules/identifier.h"
#include "rules/nearest_name.h"
#include "rules/quantity.h"
#include "rules/read_header.h"
#include "rules/read_requirement.h"
#include "rules/read_where.h"

namespace gabarit {

namespace {

Severity read_severity(RuleText& text, KeyedMap& map) {
  const std::vector<std::string> names{"error", "warning", "note"};
  const YamlNode* node = map.optional("severity");
  if (!node) return Severity::error;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (node->kind == YamlNode::Kind::scalar && node->text == names[i]) return static_cast<Severity>(i);
  }
  text.error(*node, fmt::format("unknown severity `{}`", node->text), name_hint(node->text, names));
  return Severity::error;
}

double read_ignore(RuleText& text, const YamlNode& node) {
  KeyedMap map(text, node, "`ignore`");
  const YamlNode* area = map.required("regions under");
  map.refuse_others();
  if (!area) return 0;
  const auto value = read_quantity(area->text, Dimension::area);
  if (!value) {
    text.error(*area, value.error().message, value.error().hint);
  } else if (*value < 0) {
    text.error(*area, "an area is not negative");
  }
  return value ? *value : 0;
}

Rule read_rule(RuleText& text, const YamlNode& node, const Catalogue& catalogue) {
  Rule rule;
  rule.place = text.place(node);
  KeyedMap map(text, node, "a rule");
  rule.id = read_identifier(text, map);
  rule.title = map.line("title");
  if (rule.title.empty()) rule.title = rule.id;
  rule.clause = map.line("clause");
  rule.severity = read_severity(text, map);
  if (const YamlNode* where = map.optional("where")) rule.where = read_where(text, *where, catalogue);
  if (const YamlNode* require = map.required("require"))
    rule.require = read_requirement(text, *require, catalogue);
  if (const YamlNode* ignore = map.optional("ignore")) rule.ignore_area = read_ignore(text, *ignore);
  map.refuse_others();
  return rule;
}

void refuse_repeated_id(RuleText& text, const YamlNode& node, const Rule& rule,
                        std::map<std::string, int>& lines) {
  if (rule.id.empty()) return;
  const auto [there, fresh] = lines.emplace(identifier_key(rule.id), node.line);
  if (fresh) return;
  const YamlNode* at = &node;
  for (const YamlEntry& entry : node.entries) {
    if (entry.key.text == "id") at = &entry.value;
  }
  text.error(*at, fmt::format("the id `{}` is already used by the rule at line {}", rule.id, there->second),
             "ids name files: every rule has its own, whatever the case of its letters");
}

void read_list(RuleText& text, const YamlNode& node, const Catalogue& catalogue, RuleSet& rules) {
  if (node.kind != YamlNode::Kind::list || node.items.empty()) {
    text.error(node, "`rules` is a list of rules", "a file without a rule would check nothing");
    return;
  }
  std::map<std::string, int> lines;
  for (const YamlNode& item : node.items) {
    rules.rules.push_back(read_rule(text, item, catalogue));
    refuse_repeated_id(text, item, rules.rules.back(), lines);
  }
}

// Whether this program knows the version of the language that the file is written in.
bool check_version(RuleText& text, KeyedMap& map) {
  const YamlNode* version = map.required("gabarit");
  if (!version || version->text == "1") return true;
  text.error(*version, fmt::format("unknown version `{}` of the rule language", version->text),
             "this program reads `gabarit: 1`");
  return false;
}

void read_root(RuleText& text, const YamlNode& root, const Catalogue& catalogue, RuleSet& rules) {
  if (root.kind == YamlNode::Kind::null) {
    text.error({}, "the file is empty", "a rule file begins with `gabarit: 1`");
    return;
  }
  KeyedMap map(text, root, "a rule file");
  if (root.kind != YamlNode::Kind::map || !check_version(text, map)) return;
  read_header(text, map, rules);
  if (const YamlNode* list = map.required("rules")) read_list(text, *list, catalogue, rules);
  map.refuse_others();
}

Diagnostics unreadable(const std::filesystem::path& file, const std::string& why) {
  return {{.file = file.string(), .message = "the rule file can't be read: " + why}};
}

}  // namespace

Result<RuleSet> read_rules_text(const std::string& text, const std::string& name,
                                const Catalogue& catalogue) {
  auto tree = read_yaml(text, name);
  if (!tree) return tree.error();
  RuleText reading(name, text);
  RuleSet rules;
  read_root(reading, tree->root, catalogue, rules);
  if (reading.has_errors() || !tree->errors.empty()) return reading.all_errors(std::move(tree->errors));
  rules.file = std::filesystem::path(name).filename().string();
  rules.text = text;
  rules.sha256 = sha256(text);
  return rules;
}

Result<RuleSet> read_rules(const std::filesystem::path& file, const Catalogue& catalogue) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) return unreadable(file, "it is a directory");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return unreadable(file, std::strerror(errno));
  std::string text((std::size_t{1} << 20) + 1, '\0');  // one byte more than is accepted
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) return unreadable(file, std::strerror(errno));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return read_rules_text(text, file.string(), catalogue);
}

}  // namespace gabarit
