// An angle less the nearest multiple of a right angle.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "gpu/qualifiers.h"
#include "gpu/separate.h"

namespace gabarit {

// x = quarters · π/2 + angle + rest, of which only the lowest two bits of `quarters` mean something;
// |angle| is at most π/4 and some rounding, and `rest` holds what it lacks in digits.
struct ReducedAngle {
  double angle = 0, rest = 0;
  int quarters = 0;
};

// By subtraction of multiples of π/2 in three pieces of 43, 43 and 53 bits, of which the first two are exact
// (Cody & Waite, Software Manual for the Elementary Functions, 1980); up to 256 quarters.
GABARIT_HD inline ReducedAngle reduced_by_pieces(double x) {
  constexpr double whole = 0x1.8p52;  // added and taken away again it rounds to a whole number
  const double n = (x * 0x1.45f306dc9c883p-1 + whole) - whole;
  const double a = x - n * 0x1.921fb54442c00p+0, b = n * 0x1.18469898cc400p-44;
  const double t = a - b, back = a - t, lost = (a - (t + back)) + (back - b);
  const double c = n * 0x1.1701b839a2520p-88, angle = t - c;
  return {angle, ((t - angle) - c) + lost, static_cast<int>(n)};
}

GABARIT_HD inline std::uint64_t high_product(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t a0 = a & 0xFFFFFFFFU, a1 = a >> 32, b0 = b & 0xFFFFFFFFU, b1 = b >> 32;
  const std::uint64_t middle = a1 * b0 + (a0 * b0 >> 32), other = a0 * b1 + (middle & 0xFFFFFFFFU);
  return a1 * b1 + (middle >> 32) + (other >> 32);
}

// 64 bits of 2/π, from the given bit behind the point on; -64 at least.
GABARIT_HD inline std::uint64_t bits_of_two_over_pi(int from) {
  constexpr std::uint64_t digits[] = {0,
                                      0xA2F9836E4E441529U,
                                      0xFC2757D1F534DDC0U,
                                      0xDB6295993C439041U,
                                      0xFE5163ABDEBBC561U,
                                      0xB7246E3A424DD2E0U,
                                      0x06492EEA09D1921CU,
                                      0xFE1DEB1CB129A73EU,
                                      0xE88235F52EBB4484U,
                                      0xE99C7026B45F7E41U,
                                      0x3991D639835339F4U,
                                      0x9C845F8BBDF9283BU,
                                      0x1FF897FFDE05980FU,
                                      0xEF2F118B5A0A6D1FU,
                                      0x6D367ECF27CB09B7U,
                                      0x4F463F669E5FEA2DU,
                                      0x7527BAC7EBE5F17BU,
                                      0x3D0739F78A5292EAU,
                                      0x6BFB5FB11F8D5D08U,
                                      0x56033046FC7B6BABU};
  const int word = (from + 64) / 64, bit = (from + 64) % 64;
  return bit == 0 ? digits[word] : digits[word] << bit | digits[word + 1] >> (64 - bit);
}

// x · 2/π modulo 4, for any finite x of at least 1: quarters and a fraction of 128 bits. By as many digits of
// 2/π as make a difference (M. Payne & R. Hanek, Radian Reduction for Trigonometric Functions, 1983).
struct QuarterDigits {
  int quarters;
  std::uint64_t high, low;

  GABARIT_HD explicit QuarterDigits(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int exponent = static_cast<int>(bits >> 52 & 0x7FFU) - 1075;  // x = ± mantissa · 2^exponent
    const std::uint64_t mantissa = (bits & 0xFFFFFFFFFFFFFU) | 0x10000000000000U;
    // Digits before these make multiples of four quarters. Their products count in 2^-62, 2^-126 and 2^-190.
    const std::uint64_t first = bits_of_two_over_pi(exponent - 2),
                        second = bits_of_two_over_pi(exponent + 62),
                        third = bits_of_two_over_pi(exponent + 126);
    const std::uint64_t product = mantissa * second, sum = product + high_product(mantissa, third);
    const std::uint64_t carry = sum < product ? 1 : 0;
    const std::uint64_t all = mantissa * first + high_product(mantissa, second) + carry;
    quarters = static_cast<int>(all >> 62);
    high = all << 2 | sum >> 62, low = sum << 2;
  }
};

GABARIT_HD inline double scaled_by_two_to(int power, std::uint64_t mantissa) {
  return static_cast<double>(mantissa) *
         std::bit_cast<double>(static_cast<std::uint64_t>(1023 + power) << 52);
}

GABARIT_SEPARATE GABARIT_HD inline ReducedAngle reduced_by_digits(double x) {
  QuarterDigits digits(x);
  const bool down = digits.high >> 63 != 0;  // from a half on it counts down to the next quarter
  if (down) ++digits.quarters, digits.high = ~digits.high, digits.low = ~digits.low;
  // Its leading 26 bits, the 27 and the 53 after them; no double is so near to a quarter that `high` is 0.
  const int zeros = std::countl_zero(digits.high | 1);
  const std::uint64_t lead = digits.high << zeros | digits.low >> (64 - zeros), next = digits.low << zeros;
  const double a = scaled_by_two_to(-26 - zeros, lead >> 38),
               b = scaled_by_two_to(-53 - zeros, lead >> 11 & 0x7FFFFFFU),
               c = scaled_by_two_to(-106 - zeros, (lead & 0x7FFU) << 42 | next >> 22);
  // Times π/2, of which the first 27 bits times those 26 are exact.
  constexpr double pi_a = 0x1.921fb54p+0, pi_b = 0x1.10b46p-30, pi_c = 0x1.1a62633145c07p-54;
  const double first = a * pi_a;
  const double more = b * pi_a + a * pi_b + (b * pi_b + (c * pi_a + a * pi_c));
  const double angle = first + more, rest = more - (angle - first);
  const double sign = (x < 0) != down ? -1 : 1;
  return {sign * angle, sign * rest, x < 0 ? -digits.quarters : digits.quarters};
}

// Of a finite angle.
GABARIT_HD inline ReducedAngle reduced_angle(double x) {
  constexpr double few = 400;  // radians
  return std::fabs(x) < few ? reduced_by_pieces(x) : reduced_by_digits(x);
}

}  // namespace gabarit
