#include "rules/yaml_tree.h"

#include <algorithm>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include "rules/source_text.h"

namespace gabarit {

namespace {

struct Refusal {
  YAML::Mark mark;
  std::string message, hint;
};

YamlNode node_at(const YAML::Mark& mark, YamlNode::Kind kind) {
  YamlNode node;
  node.kind = kind;
  node.line = mark.line + 1;
  node.column = mark.column + 1;
  return node;
}

// Builds the tree from the parser's events: aliases are refused before anything is expanded.
class TreeBuilder : public YAML::EventHandler {
 public:
  YamlNode root;
  std::vector<std::pair<YamlNode, std::string>> repeated;

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (documents_++ > 0) {
      throw Refusal{mark, "something follows the end of the document", "a rule file is one YAML document"};
    }
  }
  void OnDocumentEnd() override {}
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { refuse_anchor(mark); }
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (anchor != 0) refuse_anchor(mark);
    add(node_at(mark, YamlNode::Kind::null));
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    check(mark, tag, anchor);
    YamlNode node = node_at(mark, YamlNode::Kind::scalar);
    node.text = value;
    node.length = std::max(1, character_count(value) + (tag == "!" ? 2 : 0));
    add(std::move(node));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, YamlNode::Kind::list);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, YamlNode::Kind::map);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    YamlNode node;
    std::set<std::string> keys;  // of a map
    YamlNode key;                // the one whose value comes next
    bool key_read = false;
  };
  static constexpr std::size_t deepest = 24;
  static constexpr std::size_t most_repeated = 100;
  std::vector<Open> open_;
  int documents_ = 0;

  [[noreturn]] static void refuse_anchor(const YAML::Mark& mark) {
    throw Refusal{mark, "anchors and aliases (`&`, `*`) are not part of this language",
                  "write the value out"};
  }
  static void check(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    if (anchor != 0) refuse_anchor(mark);
    if (tag.empty() || tag == "?" || tag == "!") return;
    throw Refusal{mark, fmt::format("the tag `{}` is not part of this language", tag),
                  "a text that begins with `!` is written in quotes"};
  }
  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, YamlNode::Kind kind) {
    check(mark, tag, anchor);
    if (open_.size() == deepest) {
      throw Refusal{mark, "the file is nested too deeply", fmt::format("{} levels are the most", deepest)};
    }
    if (!open_.empty() && expects_key(open_.back())) refuse_key(mark);
    open_.push_back({.node = node_at(mark, kind), .keys = {}, .key = {}, .key_read = false});
  }
  void close() {
    YamlNode node = std::move(open_.back().node);
    open_.pop_back();
    add(std::move(node));
  }
  static bool expects_key(const Open& open) {
    return open.node.kind == YamlNode::Kind::map && !open.key_read;
  }
  [[noreturn]] static void refuse_key(const YAML::Mark& mark) {
    throw Refusal{mark, "a key that is not plain text", "quote it if it is meant as text"};
  }
  void add(YamlNode node) {
    if (open_.empty()) {
      root = std::move(node);
      return;
    }
    Open& open = open_.back();
    if (expects_key(open)) {
      if (node.kind != YamlNode::Kind::scalar) {
        YAML::Mark mark;
        mark.line = node.line - 1;
        mark.column = node.column - 1;
        refuse_key(mark);
      }
      open.key = std::move(node);
      open.key_read = true;
    } else if (open.node.kind == YamlNode::Kind::map) {
      add_entry(open, std::move(node));
    } else {
      open.node.items.push_back(std::move(node));
    }
  }
  // A repeated key keeps its first value. What is not there stands where its key stands.
  void add_entry(Open& open, YamlNode value) {
    open.key_read = false;
    if (value.kind == YamlNode::Kind::null) {
      value.line = open.key.line;
      value.column = open.key.column;
      value.length = open.key.length;
    }
    if (open.keys.insert(open.key.text).second) {
      open.node.entries.push_back({std::move(open.key), std::move(value)});
    } else if (repeated.size() < most_repeated) {
      repeated.emplace_back(open.key, open.key.text);
    }
  }
};

Diagnostic at_mark(const std::string& name, const std::string& text, const YAML::Mark& mark,
                   std::string message, std::string hint = {}) {
  YamlNode node = node_at(mark, YamlNode::Kind::null);
  if (mark.is_null() || mark.line < 0) node.line = node.column = 0;
  return diagnostic_at(name, text, node, std::move(message), std::move(hint));
}

}  // namespace

Diagnostic diagnostic_at(const std::string& name, const std::string& text, const YamlNode& node,
                         std::string message, std::string hint) {
  Diagnostic diagnostic{
      .file = name, .line = node.line, .column = node.column, .message = std::move(message)};
  diagnostic.hint = std::move(hint);
  if (node.line == 0) return diagnostic;
  diagnostic.source_line = line_of(text, node.line);
  const std::size_t before = static_cast<std::size_t>(std::max(0, node.column - 1));
  const std::string rest =
      before < diagnostic.source_line.size() ? diagnostic.source_line.substr(before) : "";
  diagnostic.length = std::max(1, std::min(node.length, character_count(rest)));
  constexpr std::size_t longest_shown = 400;
  if (diagnostic.source_line.size() > longest_shown) diagnostic.source_line.clear();
  return diagnostic;
}

Result<YamlTree> read_yaml(const std::string& text, const std::string& name) {
  if (const auto fault = find_text_fault(text)) {
    YamlNode node;
    node.line = fault->line;
    node.column = fault->column;
    Diagnostic found = diagnostic_at(name, text, node, fault->message, fault->hint);
    if (found.message.find("UTF-8") != std::string::npos) found.source_line.clear();  // unfit to print
    return Diagnostics{std::move(found)};
  }
  TreeBuilder builder;
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const Refusal& refusal) {
    return Diagnostics{at_mark(name, text, refusal.mark, refusal.message, refusal.hint)};
  } catch (const YAML::Exception& error) {
    return Diagnostics{at_mark(name, text, error.mark, "this is not YAML: " + error.msg)};
  }
  YamlTree tree{.root = std::move(builder.root), .errors = {}};
  for (const auto& [key, written] : builder.repeated) {
    tree.errors.push_back(diagnostic_at(name, text, key, fmt::format("`{}` is given twice", written)));
  }
  return tree;
}

}  // namespace gabarit
