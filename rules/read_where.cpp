#include "rules/read_where.h"

#include <fmt/format.h>

#include "rules/nearest_name.h"
#include "rules/read_arguments.h"

namespace gabarit {

namespace {

// What the file writes for the parameter that tells variants apart; null when it does not.
const YamlNode* written_variant(const Selector& selector, const YamlNode& value) {
  if (value.kind == YamlNode::Kind::scalar) return &value;
  for (const YamlEntry& entry : value.entries) {
    if (!selector.parameters.empty() && entry.key.text == selector.parameters.front().name)
      return &entry.value;
  }
  return nullptr;
}

// Null after a complaint. A selector without variants is the one of its name.
const Selector* pick_variant(RuleText& text, const YamlEntry& entry,
                             const std::vector<const Selector*>& candidates) {
  const Selector& first = *candidates.front();
  if (first.variant.empty() || first.parameters.empty()) return &first;
  const std::string& what = first.parameters.front().name;
  std::vector<std::string> variants;
  for (const Selector* candidate : candidates) variants.push_back(candidate->variant);
  const YamlNode* written = written_variant(first, entry.value);
  if (!written) {
    text.error(entry.key, fmt::format("`{}` needs `{}`", entry.key.text, what), name_hint("", variants));
    return nullptr;
  }
  for (const Selector* candidate : candidates) {
    if (candidate->variant == written->text) return candidate;
  }
  text.error(*written, fmt::format("unknown {} `{}`", what, written->text),
             name_hint(written->text, variants));
  return nullptr;
}

Arguments selector_arguments(RuleText& text, const YamlEntry& entry, const Selector& selector) {
  const std::string& name = entry.key.text;
  if (entry.value.kind == YamlNode::Kind::null) {
    text.error(entry.key, fmt::format("`{}` has no value", name));
    return {};
  }
  if (entry.value.kind != YamlNode::Kind::map) {
    return read_shorthand(text, selector.parameters, entry.value, entry.key, name);
  }
  KeyedMap map(text, entry.value, fmt::format("`{}`", name));
  Arguments arguments = read_arguments(text, selector.parameters, map, entry.key, name);
  map.refuse_others();
  return arguments;
}

Where read_selector(RuleText& text, const YamlEntry& entry, const Catalogue& catalogue) {
  Where where;
  where.kind = Where::Kind::selector;
  where.place = text.place(entry.key);
  const auto candidates = catalogue.selectors_named(entry.key.text);
  if (candidates.empty()) {
    std::vector<std::string> known = catalogue.selector_names();
    for (const char* word : {"all", "any", "not"}) known.emplace_back(word);
    text.error(entry.key, fmt::format("unknown selector `{}`", entry.key.text),
               name_hint(entry.key.text, known));
    return where;
  }
  where.selector = pick_variant(text, entry, candidates);
  if (where.selector) where.arguments = selector_arguments(text, entry, *where.selector);
  return where;
}

Where read_list(RuleText& text, const YamlEntry& entry, const Catalogue& catalogue) {
  Where where;
  where.kind = entry.key.text == "all" ? Where::Kind::all : Where::Kind::any;
  where.place = text.place(entry.key);
  if (entry.value.kind != YamlNode::Kind::list || entry.value.items.empty()) {
    text.error(entry.value, fmt::format("`{}` is a list of selectors", entry.key.text),
               "one selector a line, each after a dash");
    return where;
  }
  for (const YamlNode& item : entry.value.items) where.children.push_back(read_where(text, item, catalogue));
  return where;
}

Where read_not(RuleText& text, const YamlEntry& entry, const Catalogue& catalogue) {
  Where where;
  where.kind = Where::Kind::none_of;
  where.place = text.place(entry.key);
  where.children.push_back(read_where(text, entry.value, catalogue));
  return where;
}

}  // namespace

Where read_where(RuleText& text, const YamlNode& node, const Catalogue& catalogue) {
  if (node.kind != YamlNode::Kind::map || node.entries.empty()) {
    text.error(node, "a selector is wanted here",
               "such as `height: {from: 0 mm}`, or `all:`, `any:` or `not:` and selectors");
    return {};
  }
  if (node.entries.size() > 1) {
    text.error(node.entries[1].key,
               fmt::format("`{}` and `{}` stand beside each other", node.entries[0].key.text,
                           node.entries[1].key.text),
               "put several selectors into a list under `all:` or `any:`");
  }
  const YamlEntry& entry = node.entries.front();
  if (entry.key.text == "all" || entry.key.text == "any") return read_list(text, entry, catalogue);
  if (entry.key.text == "not") return read_not(text, entry, catalogue);
  return read_selector(text, entry, catalogue);
}

}  // namespace gabarit
