// A map of a rule file whose every key must be known.
#pragma once

#include <optional>

#include "rules/rule_text.h"

namespace gabarit {

class KeyedMap {
 public:
  // Complains when `node` is not a map; then every key is absent. `what` names it, such as "a rule".
  KeyedMap(RuleText& text, const YamlNode& node, std::string what);

  // Null when absent. Asking makes a key known.
  const YamlNode* optional(const std::string& key);
  // Complains when absent.
  const YamlNode* required(const std::string& key);
  // One line of text; empty when absent.
  std::string line(const std::string& key);
  std::string required_line(const std::string& key);

  // Complains of every key that nobody asked for.
  void refuse_others();

 private:
  std::string line_at(const std::string& key, const YamlNode* node);

  RuleText* text_;
  const YamlNode* node_;
  std::string what_;
  bool is_map_;
  std::vector<std::string> known_;
};

}  // namespace gabarit
