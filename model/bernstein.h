// Where a function given by Bézier coefficients changes its sign.
#pragma once

#include <cstdint>
#include <vector>

#include "model/brep.h"

namespace gabarit {

// Walks over consecutive intervals and notes every change of sign, none missed: a polynomial has no more
// roots than its coefficients have changes of sign, and an interval with a change is halved until it is a
// point of the parameter. Coefficients below `noise` have no sign, so a stretch that is level has none
// either.
class SignChanges {
 public:
  // The coefficients of one polynomial over [from, to]; intervals follow one another.
  void add(std::vector<double> coefficients, double from, double to, double noise);
  const std::vector<double>& at() const { return at_; }

 private:
  void walk(std::vector<double>& c, double from, double to, int depth);

  std::vector<double> at_;
  int last_sign_ = 0;
};

// The Bézier poles (homogeneous) of the span [knots[span], knots[span + 1]] of a spline curve.
std::vector<Pole> bezier_poles(const Brep& brep, const Curve& curve, int span);
// Bernstein coefficients of a'·b - a·b' of degree 2·p - 1, for a and b of degree p: the sign of (a/b)'.
std::vector<double> quotient_slope(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace gabarit
