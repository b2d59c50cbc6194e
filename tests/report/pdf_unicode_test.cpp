#include <gtest/gtest.h>

#include "report/pdf/unicode.h"

namespace gabarit::pdf {
namespace {

TEST(code_points, of_good_text_are_its_letters) {
  EXPECT_EQ(code_points("aé日🏍"), U"aé日🏍");
  EXPECT_EQ(utf8(U"aé日🏍"), "aé日🏍");
}

TEST(code_points, bytes_that_are_no_utf8_are_replaced_one_by_one) {
  EXPECT_EQ(code_points("a\xffz"), U"a\uFFFDz");
  EXPECT_EQ(code_points("\xc3"), U"\uFFFD");
  EXPECT_EQ(code_points("\xe6\x97z"), U"\uFFFD\uFFFDz");
  EXPECT_EQ(code_points("\xc0\xaf"), U"\uFFFD\uFFFD") << "overlong";
  EXPECT_EQ(code_points("\xed\xa0\x80"), U"\uFFFD\uFFFD\uFFFD") << "surrogate";
  EXPECT_EQ(code_points("\xf5\x80\x80\x80"), U"\uFFFD\uFFFD\uFFFD\uFFFD");
}

TEST(code_points, what_would_steer_a_reader_is_replaced) {
  EXPECT_EQ(code_points("a\x1b[31m"), U"a\uFFFD[31m");
  EXPECT_EQ(code_points("a\u202eb\u2066c"), U"a\uFFFDb\uFFFDc");
  EXPECT_EQ(code_points("a\tb\nc"), U"a b c");
}

}  // namespace
}  // namespace gabarit::pdf
