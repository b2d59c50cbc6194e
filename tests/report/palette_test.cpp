#include "report/palette.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace gabarit {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Triple times(const Matrix& m, const Triple& v) {
  Triple r{};
  for (std::size_t i = 0; i < 3; ++i) r[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return r;
}

// CIELAB under D65 of a colour as an eye sees it whose cones answer by `sight` in linear RGB.
Triple lab(Rgb colour, const Matrix& sight) {
  Triple rgb = times(sight, {linear(colour.r), linear(colour.g), linear(colour.b)});
  for (double& c : rgb) c = std::min(1.0, std::max(0.0, c));
  const Matrix to_xyz{{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
  const Triple xyz = times(to_xyz, rgb);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f(xyz[0] / 0.95047);
  const double y = f(xyz[1]);
  const double z = f(xyz[2] / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

const Matrix normal{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
const Matrix protanopia{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
const Matrix deuteranopia{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
const Matrix tritanopia{
    {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};

double distance(Rgb a, Rgb b, const Matrix& sight) {
  const Triple p = lab(a, sight);
  const Triple q = lab(b, sight);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

double lightness(Rgb colour) { return lab(colour, normal)[0]; }

const std::array contact_colours{palette::fail, palette::pass, palette::out_of_reach, palette::undecided};

TEST(palette, contact_colours_get_lighter_in_steps_that_a_grey_print_shows) {
  for (std::size_t i = 0; i + 1 < contact_colours.size(); ++i) {
    EXPECT_GE(lightness(contact_colours[i + 1]) - lightness(contact_colours[i]), 8);
  }
}

TEST(palette, contact_colours_stay_apart_for_colour_blind_eyes) {
  for (const Matrix& sight : {normal, protanopia, deuteranopia, tritanopia}) {
    for (std::size_t i = 0; i < contact_colours.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GE(distance(contact_colours[i], contact_colours[j], sight), 25);
      }
    }
  }
}

TEST(colour_scale, is_darker_beyond_the_limit_than_anywhere_within) {
  for (const Limit& limit : {Limit{Limit::Kind::at_least, 4, 0}, Limit{Limit::Kind::at_most, 0, 4},
                             Limit{Limit::Kind::between, 4, 6}}) {
    const ColourScale scale{0, 10, limit};
    for (double value = 0; value <= 10; value += 0.01) {
      const bool beyond = (limit.kind != Limit::Kind::at_most && value < limit.low) ||
                          (limit.kind != Limit::Kind::at_least && value > limit.high);
      const double l = lightness(scale.colour(value));
      EXPECT_TRUE(beyond ? l < 63 : l > 67) << value << " " << l;
    }
  }
}

TEST(colour_scale, changes_exactly_at_the_limit_and_is_darkest_at_the_worst) {
  const ColourScale scale{0, 10, Limit{Limit::Kind::at_least, 4, 0}};
  EXPECT_GT(lightness(scale.colour(4)), 90);
  EXPECT_LT(lightness(scale.colour(std::nextafter(4.0, 0.0))), 63);
  EXPECT_LT(lightness(scale.colour(0)), lightness(scale.colour(2)));
  EXPECT_LT(lightness(scale.colour(2)), lightness(scale.colour(3.9)));
}

TEST(colour_scale, without_a_limit_gets_steadily_lighter) {
  const ColourScale scale{0, 1, {}};
  double before = 0;
  for (double value = 0; value <= 1; value += 1.0 / 64) {
    EXPECT_GT(lightness(scale.colour(value)), before);
    before = lightness(scale.colour(value));
  }
}

TEST(colour_scale, of_the_papers_goes_from_red_to_blue) {
  const ColourScale scale{0, 1, {}, ColourMap::red_to_blue};
  EXPECT_GT(scale.colour(0).r, 200);
  EXPECT_EQ(scale.colour(0).b, 0);
  EXPECT_GT(scale.colour(1).b, 150);
  EXPECT_LT(scale.colour(1).r, 50);
}

TEST(colour_scale, has_an_answer_for_values_outside_and_for_none) {
  for (const ColourMap map : {ColourMap::by_limit, ColourMap::sequential, ColourMap::red_to_blue}) {
    const ColourScale scale{1, 9, Limit{Limit::Kind::at_least, 4, 0}, map};
    EXPECT_EQ(scale.colour(-100), scale.colour(1));
    EXPECT_EQ(scale.colour(INFINITY), scale.colour(9));
    EXPECT_EQ(scale.colour(-INFINITY), scale.colour(1));
    EXPECT_EQ(scale.colour(NAN), palette::no_value);
  }
  const ColourScale none{4, 4, Limit{Limit::Kind::at_least, 4, 0}};
  EXPECT_LT(lightness(none.colour(3)), 63);
  EXPECT_GT(lightness(none.colour(5)), 67);
}

}  // namespace
}  // namespace gabarit
