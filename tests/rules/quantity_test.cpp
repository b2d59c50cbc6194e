#include "rules/quantity.h"

#include <clocale>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace gabarit {
namespace {

double read(const std::string& text, Dimension dimension = Dimension::length) {
  const auto value = read_quantity(text, dimension);
  EXPECT_TRUE(value) << text << ": " << value.error().message;
  return value ? *value : -12345;
}

std::string fault(const std::string& text, Dimension dimension = Dimension::length) {
  const auto value = read_quantity(text, dimension);
  return value ? "fine" : value.error().message;
}

TEST(Quantity, is_read_in_millimetres_and_radians) {
  EXPECT_DOUBLE_EQ(read("4 mm"), 4);
  EXPECT_DOUBLE_EQ(read("0.5mm"), 0.5);
  EXPECT_DOUBLE_EQ(read("+.5 mm"), 0.5);
  EXPECT_DOUBLE_EQ(read("-2 cm"), -20);
  EXPECT_DOUBLE_EQ(read("2 m"), 2000);
  EXPECT_DOUBLE_EQ(read("1 in"), 25.4);
  EXPECT_DOUBLE_EQ(read("1e-3 m"), 1);
  EXPECT_DOUBLE_EQ(read("2 cm2", Dimension::area), 200);
  EXPECT_DOUBLE_EQ(read("3 mm²", Dimension::area), 3);
  EXPECT_DOUBLE_EQ(read("1 in2", Dimension::area), 645.16);
  EXPECT_DOUBLE_EQ(read("30 deg", Dimension::angle), std::numbers::pi / 6);
  EXPECT_DOUBLE_EQ(read("0.25 rad", Dimension::angle), 0.25);
  EXPECT_DOUBLE_EQ(read("7", Dimension::count), 7);
  EXPECT_DOUBLE_EQ(read("0.7", Dimension::number), 0.7);
}

TEST(Quantity, what_is_no_decimal_number_is_refused) {
  for (const char* text : {"nan mm", "inf mm", "-inf mm", "infinity mm", "four mm", "", "mm", "- 4 mm",
                           "+-4 mm", "e4 mm", ". mm"}) {
    EXPECT_EQ(fault(text), fmt::format("`{}` is not a length", text));
  }
  EXPECT_EQ(fault("0x10 mm"), "unknown unit `x10 mm`");
  EXPECT_EQ(fault("1e999 mm"), "`1e999 mm` is outside the range of numbers");
  EXPECT_EQ(fault("1e308 m"), "`1e308 m` is outside the range of numbers");
  EXPECT_EQ(fault("4 mm mm"), "unknown unit `mm mm`");
  EXPECT_EQ(fault("1,5 mm"), "`1,5 mm` has a comma");
  EXPECT_EQ(fault("1.5", Dimension::count), "`1.5` is not a whole number");
  EXPECT_EQ(fault("-1", Dimension::count), "`-1` is not a whole number");
  EXPECT_EQ(fault("1 mm", Dimension::number), "`1 mm` has something after the number");
}

TEST(Quantity, a_unit_must_be_there_and_of_the_right_kind) {
  EXPECT_EQ(fault("4"), "`4` has no unit");
  EXPECT_EQ(fault("4 deg"), "`4 deg` is an angle, a length is wanted");
  EXPECT_EQ(fault("4 mm", Dimension::area), "`4 mm` is a length, an area is wanted");
  EXPECT_EQ(fault("4 furlong"), "unknown unit `furlong`");
  EXPECT_EQ(read_quantity("4 MM", Dimension::length).error().hint,
            "did you mean `mm`? units of a length: mm, cm, m, in");
}

TEST(Quantity, does_not_follow_the_locale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
    std::setlocale(LC_ALL, name);  // those that are installed
    EXPECT_DOUBLE_EQ(read("1.5 mm"), 1.5);
    EXPECT_EQ(quantity_text(1.5, Dimension::length), "1.5 mm");
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Quantity, is_written_as_it_would_be_read) {
  EXPECT_EQ(quantity_text(4, Dimension::length), "4 mm");
  EXPECT_EQ(quantity_text(0.1, Dimension::area), "0.1 mm2");
  EXPECT_EQ(quantity_text(std::numbers::pi / 6, Dimension::angle), "30 deg");
  EXPECT_EQ(quantity_text(3, Dimension::count), "3");
  for (const double value : {0.1, 1.0 / 3, 1e-9, 123456.789}) {
    EXPECT_EQ(read(quantity_text(value, Dimension::length)), value);
  }
}

}  // namespace
}  // namespace gabarit
