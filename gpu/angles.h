// Sines, cosines, angles and hyperbolic functions that give the same bits on every device: the libraries of
// CPUs and GPUs differ in the last digits of theirs. Polynomials by E. Y. Remez's exchange (1934), computed
// with sixty digits; nothing but sums, products, quotients and square roots is used, which IEEE 754 fixes.
// Errors, over millions of values against four times the precision: sine and cosine 0.83 units in the last
// place, also of huge angles and beside multiples of π/2, angle_of 1.8, arc cosine 2.8, hyperbolic ones 1.7.
#pragma once

#include "gpu/angle_reduction.h"

namespace gabarit {

struct SineCosine {
  double sine = 0, cosine = 1;
};

// Of an angle of at most π/4 and its rest.
GABARIT_HD inline SineCosine sine_cosine_near_zero(double x, double rest) {
  const double w = x * x, ww = w * w;
  const double p = (-0.1666666666666663 + w * 0.008333333333322108) +
                   ww * ((-0.00019841269829580329 + w * 2.7557313618060165e-06) +
                         ww * (-2.5050747223405e-08 + w * 1.5896197873538838e-10));
  const double q = (0.041666666666666595 + w * -0.001388888888887304) +
                   ww * ((2.4801587288841367e-05 + w * -2.755731417623388e-07) +
                         ww * (2.087570041558362e-09 + w * -1.135851393858682e-11));
  const double half = 0.5 * w, near = 1 - half;
  return {x + (x * w * p + (rest - half * rest)), near + (((1 - near) - half) + (ww * q - x * rest))};
}

// Of any angle, also a huge one; not numbers where it is not finite. The sine of -0 is -0.
GABARIT_HD inline SineCosine sine_cosine(double x) {
  constexpr double eighth = 0x1.921fb54442d18p-1;
  if (std::fabs(x) < 0x1p-27) return {x, 1};
  if (std::fabs(x) <= eighth) return sine_cosine_near_zero(x, 0);
  if (!std::isfinite(x)) return {x - x, x - x};
  const ReducedAngle reduced = reduced_angle(x);
  const SineCosine r = sine_cosine_near_zero(reduced.angle, reduced.rest);
  switch (reduced.quarters & 3) {
    case 0: return r;
    case 1: return {r.cosine, -r.sine};
    case 2: return {-r.sine, -r.cosine};
    default: return {-r.cosine, r.sine};
  }
}
GABARIT_HD inline double sine(double x) { return sine_cosine(x).sine; }
GABARIT_HD inline double cosine(double x) { return sine_cosine(x).cosine; }

// The arc tangent of small / large, from 0 to 1; counted from the nearer of 0 and π/4.
GABARIT_HD inline double arc_tangent_to_one(double small, double large) {
  constexpr double middle = 0x1.a827999fcef32p-2, eighth = 0x1.921fb54442d18p-1, rest = 0x1.1a62633145c07p-55;
  const bool steep = small > middle * large;  // the tangent of π/8
  const double x = (steep ? small - large : small) / (steep ? small + large : large);
  const double w = x * x, ww = w * w, w4 = ww * ww;
  const double p = ((-0.33333333333333326 + w * 0.19999999999997645) +
                    ww * (-0.1428571428538542 + w * 0.11111111088035584)) +
                   w4 * (((-0.09090908140009048 + w * 0.07692282668819696) +
                          ww * (-0.06666225594269835 + w * 0.0587701185164822)) +
                         w4 * ((-0.05218348766070939 + w * 0.04503354299769881) +
                               ww * (-0.03347057359764073 + w * 0.015191822810486557)));
  const double bend = x * w * p;
  return steep ? eighth + (x + (bend + rest)) : x + bend;
}

// Of the point (x, y), from -π to π, as atan2 has it: signed zeros and infinities tell the side.
GABARIT_HD inline double angle_of(double y, double x) {
  constexpr double quarter = 0x1.921fb54442d18p+0, quarter_rest = 0x1.1a62633145c07p-54;
  constexpr double half = 0x1.921fb54442d18p+1, half_rest = 0x1.1a62633145c07p-53;
  if (!(x == x && y == y)) return x + y;
  const double across = std::fabs(x), up = std::fabs(y);
  const bool steep = up > across, back = std::signbit(x);
  double large = steep ? up : across, small = steep ? across : up;
  if (small == large) small = large = large > 0 ? 1 : 0;
  // Their sum has to have room, and their products their digits.
  const double scale = large > 0x1p1022 ? 0.25 : large < 0x1p-960 ? 0x1p60 : 1;
  small *= scale, large *= scale;
  double angle = large > 0 ? arc_tangent_to_one(small, large) : 0;
  if (steep)
    angle = back ? quarter + (angle + quarter_rest) : quarter - (angle - quarter_rest);
  else if (back)
    angle = half - (angle - half_rest);
  return std::copysign(angle, y);
}

// From 0 to π; not a number beyond -1 and 1.
GABARIT_HD inline double arc_cosine(double x) { return 2 * angle_of(std::sqrt(1 - x), std::sqrt(1 + x)); }

// Half of e to the power of x >= 0; infinite from 710.5 on.
GABARIT_HD inline double half_exponential(double x) {
  if (!(x < 711)) return x * 0x1p1023;
  constexpr double whole = 0x1.8p52;
  const double n = (x * 0x1.71547652b82fep+0 + whole) - whole;
  const double high = x - n * 0x1.62e42fefa3000p-1, low = n * 0x1.3de6af278ece6p-42, r = high - low;
  const double rest = (high - r) - low, ww = r * r;
  const double p =
      ((0.5 + r * 0.1666666666666667) + ww * (0.041666666666666685 + r * 0.008333333333326082)) +
      ww * ww *
          (((0.001388888888887429 + r * 0.00019841269875003773) +
            ww * (2.4801587347591545e-05 + r * 2.7557255168352456e-06)) +
           ww * ww * ((2.7557252672159105e-07 + r * 2.5105313336916906e-08) + ww * 2.0921669819335872e-09));
  // In two factors: twice the value may have no room.
  const double value = 1 + (r + (ww * p + rest));
  const int power = static_cast<int>(n) - 1, most = power > 1000 ? 1000 : power;
  return scaled_by_two_to(power - most, 1) * (scaled_by_two_to(most, 1) * value);
}

struct HyperbolicSineCosine {
  double sine = 0, cosine = 1;
};

GABARIT_HD inline HyperbolicSineCosine hyperbolic_sine_cosine(double x) {
  const double half = half_exponential(std::fabs(x)), inverse = 0.25 / half;
  if (std::fabs(x) >= 1) return {std::copysign(half - inverse, x), half + inverse};
  const double w = x * x, ww = w * w;
  const double p =
      (0.16666666666666669 + w * 0.008333333333333148) +
      ww * ((0.00019841269841431875 + w * 2.7557319157070645e-06) +
            ww * ((2.505212313691506e-08 + w * 1.60572597541852e-10) + ww * 7.758749227819662e-13));
  return {x + x * w * p, half + inverse};
}

}  // namespace gabarit
