#include "rules/keyed_map.h"

#include <algorithm>

#include <fmt/format.h>

#include "rules/nearest_name.h"

namespace gabarit {

KeyedMap::KeyedMap(RuleText& text, const YamlNode& node, std::string what)
    : text_(&text), node_(&node), what_(std::move(what)), is_map_(node.kind == YamlNode::Kind::map) {
  if (!is_map_) text_->error(node, fmt::format("{} is a map of keys and values", what_));
}

const YamlNode* KeyedMap::optional(const std::string& key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
  const auto found = std::find_if(node_->entries.begin(), node_->entries.end(),
                                  [&](const YamlEntry& entry) { return entry.key.text == key; });
  return found == node_->entries.end() ? nullptr : &found->value;
}

const YamlNode* KeyedMap::required(const std::string& key) {
  const YamlNode* node = optional(key);
  if (!node && is_map_) text_->error(*node_, fmt::format("{} needs `{}`", what_, key));
  return node;
}

std::string KeyedMap::line(const std::string& key) { return line_at(key, optional(key)); }

std::string KeyedMap::required_line(const std::string& key) { return line_at(key, required(key)); }

std::string KeyedMap::line_at(const std::string& key, const YamlNode* node) {
  constexpr std::size_t longest = 400;
  if (!node) return {};
  if (node->kind != YamlNode::Kind::scalar || node->text.empty()) {
    text_->error(*node, fmt::format("`{}` is a line of text", key));
    return {};
  }
  if (node->text.find_first_of("\n\t\r") != std::string::npos || node->text.size() > longest) {
    text_->error(*node, fmt::format("`{}` is one line of at most {} bytes", key, longest));
    return {};
  }
  return node->text;
}

void KeyedMap::refuse_others() {
  for (const YamlEntry& entry : node_->entries) {
    if (std::find(known_.begin(), known_.end(), entry.key.text) != known_.end()) continue;
    text_->error(entry.key, fmt::format("unknown key `{}` in {}", entry.key.text, what_),
                 entry.key.text == "<<" ? "merge keys are not part of this language"
                                        : name_hint(entry.key.text, known_));
  }
}

}  // namespace gabarit
