// A rule file while it is read: its text, and what was found wrong so far.
#pragma once

#include "rules/rule.h"
#include "rules/yaml_tree.h"

namespace gabarit {

class RuleText {
 public:
  RuleText(const std::string& name, const std::string& text) : name_(&name), text_(&text) {}

  void error(const YamlNode& at, std::string message, std::string hint = {});
  Place place(const YamlNode& node) const;
  bool has_errors() const { return !found_.empty(); }
  // In the order of the file, with those that the YAML reader found; after a hundred only how many more.
  Diagnostics all_errors(Diagnostics others = {});

 private:
  const std::string* name_;
  const std::string* text_;
  struct Fault {
    YamlNode at;
    std::string message, hint;
  };
  std::vector<Fault> found_;
};

}  // namespace gabarit
