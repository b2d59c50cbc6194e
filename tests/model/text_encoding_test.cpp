#include "model/text_encoding.h"

#include <gtest/gtest.h>

namespace gabarit {
namespace {

const std::string bad = "\xEF\xBF\xBD";

TEST(text_encoding, good_text_stays_as_it_is) {
  for (const std::string text : {"", "frame left", "Käse", "日本", "\xF4\x8F\xBF\xBF", "\xED\x9F\xBF"})
    EXPECT_EQ(valid_utf8(text), text);
}

TEST(text_encoding, every_byte_that_is_no_utf_8_is_marked) {
  EXPECT_EQ(valid_utf8("K\xE4se"), "K" + bad + "se");
  EXPECT_EQ(valid_utf8("\x80"), bad);
  EXPECT_EQ(valid_utf8("\xC0\xAF"), bad + bad);                      // overlong
  EXPECT_EQ(valid_utf8("\xE0\x80\x80"), bad + bad + bad);            // overlong
  EXPECT_EQ(valid_utf8("\xED\xA0\x80"), bad + bad + bad);            // half of a surrogate pair
  EXPECT_EQ(valid_utf8("\xF4\x90\x80\x80"), bad + bad + bad + bad);  // beyond Unicode
  EXPECT_EQ(valid_utf8("a\xE2\x82"), "a" + bad + bad);               // cut short
  EXPECT_EQ(valid_utf8("\xFF\xFE"), bad + bad);
}

TEST(text_encoding, control_characters_become_blanks) {
  EXPECT_EQ(valid_utf8(std::string("a\0b\x1B[31m\nc\x7F", 10)), "a b [31m c");
}

}  // namespace
}  // namespace gabarit
