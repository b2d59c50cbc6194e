#include "model/number_word.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace gabarit {
namespace {

double number(std::string_view word) {
  double value = 12345;
  EXPECT_TRUE(read_number(word, value)) << word;
  return value;
}

TEST(number_word, reads_the_decimal_numbers_that_exporters_write) {
  EXPECT_EQ(number("0.1"), 0.1);
  EXPECT_EQ(number("+1.5E+1"), 15);
  EXPECT_EQ(number("-.5"), -0.5);
  EXPECT_EQ(number("3."), 3);
  EXPECT_EQ(number("1e-400"), 0);
  EXPECT_EQ(number("-1e400"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(number("1" + std::string(400, '0') + "e-400"), 1);
  EXPECT_EQ(number("0." + std::string(400, '0') + "1"), 0);
  EXPECT_TRUE(std::isnan(number("-1.#IND")));
  EXPECT_TRUE(std::isnan(number("nan")));
}

TEST(number_word, refuses_everything_else) {
  double value = 0;
  for (const char* const word :
       {"", "+", "-", "+-1", "--1", "1,5", "1.5mm", "0x10", "1e", "e5", "1.#", "1.#XYZ", "one"})
    EXPECT_FALSE(read_number(word, value)) << word;
}

TEST(number_word, an_integer_is_the_whole_word_and_fits) {
  std::int64_t value = 0;
  EXPECT_TRUE(read_integer("-9223372036854775808", value));
  EXPECT_EQ(value, std::numeric_limits<std::int64_t>::min());
  EXPECT_TRUE(read_integer("+7", value));
  EXPECT_EQ(value, 7);
  for (const char* const word : {"", "9223372036854775808", "1.0", "1/2", "0x1", "+-1", "1 "})
    EXPECT_FALSE(read_integer(word, value)) << word;
}

}  // namespace
}  // namespace gabarit
