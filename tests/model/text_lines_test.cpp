#include "model/text_lines.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace gabarit {
namespace {

using testing::ElementsAre;

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> found;
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    found.emplace_back(line);
    EXPECT_EQ(lines.number(), static_cast<int>(found.size()));
  }
  return found;
}

TEST(text_lines, end_with_any_of_the_three_line_ends) {
  EXPECT_THAT(lines_of("a\nb\r\nc\rd"), ElementsAre("a", "b", "c", "d"));
  EXPECT_THAT(lines_of("\n\r\n\r"), ElementsAre("", "", ""));
  EXPECT_THAT(lines_of("a\n"), ElementsAre("a"));
  EXPECT_THAT(lines_of(""), ElementsAre());
}

TEST(text_lines, words_stand_between_blanks_and_tabs) {
  std::string_view line = " \tv  1\t2 ";
  std::vector<std::string> words;
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line))
    words.emplace_back(word);
  EXPECT_THAT(words, ElementsAre("v", "1", "2"));
  EXPECT_EQ(trimmed("\t a b \f"), "a b");
}

TEST(text_lines, a_comment_stands_at_the_start_or_behind_a_blank) {
  EXPECT_EQ(without_comment("# all"), "");
  EXPECT_EQ(without_comment("f 1 2 3 # tail"), "f 1 2 3 ");
  EXPECT_EQ(without_comment("g part#2 #3"), "g part#2 ");
  EXPECT_EQ(without_comment("g part#2"), "g part#2");
}

}  // namespace
}  // namespace gabarit
