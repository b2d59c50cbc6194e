#include "rules/yaml_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gabarit {
namespace {

std::string error_of(const std::string& text) {
  const auto tree = read_yaml(text, "f");
  return tree ? "fine" : to_string(tree.error().at(0));
}

TEST(YamlTree, keeps_the_place_and_the_text_of_everything) {
  const auto tree = read_yaml("a: 'x y'\nb:\n  - 1\n  - {c: d}\n", "f");
  ASSERT_TRUE(tree);
  const YamlNode& root = tree->root;
  ASSERT_EQ(root.entries.size(), 2U);
  EXPECT_EQ(root.entries[0].value.text, "x y");
  EXPECT_EQ(root.entries[0].value.length, 5);
  EXPECT_EQ(root.entries[0].value.column, 4);
  const YamlNode& list = root.entries[1].value;
  ASSERT_EQ(list.items.size(), 2U);
  EXPECT_EQ(list.items[0].line, 3);
  EXPECT_EQ(list.items[1].entries.at(0).key.column, 6);
  EXPECT_EQ(list.items[1].entries.at(0).value.text, "d");
}

TEST(YamlTree, a_repeated_key_is_an_error_that_keeps_the_first_value) {
  const auto tree = read_yaml("a: 1\nb: 2\na: 3\n", "f");
  ASSERT_TRUE(tree);
  ASSERT_EQ(tree->errors.size(), 1U);
  EXPECT_EQ(to_string(tree->errors[0]), "f:3:1: error: `a` is given twice\n  a: 3\n  ^\n");
  EXPECT_EQ(tree->root.entries.at(0).value.text, "1");
}

TEST(YamlTree, what_could_expand_is_refused_before_it_does) {
  std::string laughs = "a: &a [x, x]\n";
  for (char c = 'b'; c < 'z'; ++c) {
    laughs += std::string(1, c) + ": &" + c + " [*" + static_cast<char>(c - 1) + ", *" +
              static_cast<char>(c - 1) + "]\n";
  }
  const std::string refusal = "f:1:4: error: anchors and aliases (`&`, `*`) are not part of this language\n";
  EXPECT_THAT(error_of(laughs), testing::StartsWith(refusal));
  EXPECT_THAT(error_of("a: &b 1\n"), testing::StartsWith(refusal));
  EXPECT_THAT(error_of("a: &b\n"), testing::StartsWith(refusal));
  EXPECT_THAT(
      error_of("a: !!int 1\n"),
      testing::StartsWith("f:1:4: error: the tag `tag:yaml.org,2002:int` is not part of this language\n"));
}

TEST(YamlTree, deep_nesting_is_refused) {
  const auto nested = [](int depth) {
    const auto n = static_cast<std::size_t>(depth);
    return "a: " + std::string(n, '[') + "x" + std::string(n, ']') + "\n";
  };
  EXPECT_EQ(error_of(nested(20)), "fine");
  EXPECT_THAT(error_of(nested(30)), testing::HasSubstr("the file is nested too deeply\n"));
  EXPECT_NE(error_of(nested(400000)), "fine");
  EXPECT_NE(error_of(std::string(1000000, '[')), "fine");
  std::string dashes;
  for (int i = 0; i < 500000; ++i) dashes += "- ";
  EXPECT_THAT(error_of(dashes), testing::HasSubstr("the file is nested too deeply\n"));
}

TEST(YamlTree, text_that_is_not_a_rule_file_is_named_at_its_byte) {
  EXPECT_EQ(error_of("a: \xFF\n"), "f:1:4: error: the byte 0xFF is not UTF-8\n  save the file as UTF-8\n");
  EXPECT_EQ(error_of("a: \xC0\xAF\n"),
            "f:1:4: error: the byte 0xC0 is not UTF-8\n  save the file as UTF-8\n");
  EXPECT_EQ(error_of("a: \xED\xA0\x80\n"),
            "f:1:4: error: the byte 0xED is not UTF-8\n  save the file as UTF-8\n");
  EXPECT_EQ(error_of("a: \xE2\x82"), "f:1:4: error: the byte 0xE2 is not UTF-8\n  save the file as UTF-8\n");
  EXPECT_THAT(error_of(std::string("a: \0 1\n", 7)),
              testing::HasSubstr("f:1:4: error: a control character (0x00)\n"));
  EXPECT_EQ(error_of("a:\n\t- b\n"),
            "f:2:1: error: a tab in the indentation\n  \t- b\n  ^\n  YAML is indented with spaces\n");
  EXPECT_THAT(error_of("a: 1\rb: 2\n"), testing::HasSubstr("a carriage return within a line"));
  EXPECT_EQ(error_of(std::string((std::size_t{1} << 20) + 1, 'a')),
            "f: error: the file is larger than 1 MiB\n  rule files are small: is this one?\n");
  EXPECT_EQ(error_of("ä: ö → 日本語 🏍\n"), "fine");
}

TEST(YamlTree, broken_yaml_and_second_documents_are_errors) {
  EXPECT_EQ(error_of("a: [b\nc: 1\n"),
            "f:2:2: error: this is not YAML: end of sequence flow not found\n  c: 1\n   ^\n");
  EXPECT_THAT(error_of("a: 1\n---\nb: 2\n"),
              testing::HasSubstr("f:2:1: error: something follows the end of the"));
  EXPECT_THAT(error_of("? [a]\n: b\n"), testing::HasSubstr("f:1:3: error: a key that is not plain text\n"));
  EXPECT_THAT(error_of("~: b\n"), testing::HasSubstr("f:1:1: error: a key that is not plain text\n"));
  EXPECT_NE(error_of("a: 1\n- b\n"), "fine");
}

}  // namespace
}  // namespace gabarit
