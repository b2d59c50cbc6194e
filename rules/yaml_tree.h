// The part of YAML that rule files use, as a tree that knows where everything stands.
#pragma once

#include <string>
#include <vector>

#include "model/result.h"

namespace gabarit {

struct YamlEntry;

struct YamlNode {
  enum class Kind { null, scalar, list, map };
  Kind kind = Kind::null;
  int line = 0, column = 0;  // from 1; columns count bytes
  std::string text;          // of a scalar, without quotes
  int length = 1;            // of what stands in the file, for the caret
  std::vector<YamlNode> items;
  std::vector<YamlEntry> entries;  // in the order of the file; keys are scalars, each once
};

struct YamlEntry {
  YamlNode key, value;
};

struct YamlTree {
  YamlNode root;
  Diagnostics errors;  // that leave a tree to go on with: repeated keys
};

// One document of UTF-8 text up to 1 MiB without anchors, aliases, tags, merge keys, tabs in the indentation
// or deep nesting; what is refused is named with its place. `name` stands for the file in messages.
Result<YamlTree> read_yaml(const std::string& text, const std::string& name);

// A message at a node, with the line of text and the caret under it.
Diagnostic diagnostic_at(const std::string& name, const std::string& text, const YamlNode& node,
                         std::string message, std::string hint = {});

}  // namespace gabarit
