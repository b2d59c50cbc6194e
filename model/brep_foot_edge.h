// The first contact of a pencil of balls with a piece of an edge's curve.
#pragma once

#include "model/brep_foot.h"

namespace gabarit {

struct CurveFoot {
  double t = 0;
  CurvePoint curve;
  double radius = std::numeric_limits<double>::infinity();
  double residual = std::numeric_limits<double>::infinity();  // mm: of the arm along the curve
  int iterations = 0;
  bool inside = false;  // stationary; else the end of the piece is nearest
};

// Newton's method between two ends, kept there by halving: the sign of the slope is known also where no ball
// gets, behind the pencil's tangent plane. The piece is so short that there is one minimum on it. Its ends
// are looked at only when a step leads beyond them.
class CurveDescent {
 public:
  GABARIT_HD CurveDescent(const BrepView& brep, const Curve& curve, const Pencil& pencil)
      : brep_(brep), curve_(curve), pencil_(pencil) {}

  GABARIT_SEPARATE GABARIT_HD CurveFoot run(double first, double last, double from) const {
    const double least = first < last ? first : last, most = first < last ? last : first;
    double low = least, high = most, t = from > low && from < high ? from : low + (high - low) / 2;
    bool least_seen = false, most_seen = false;
    CurveFoot foot;
    for (int iterations = 0;; ++iterations) {
      foot = at(t);
      foot.iterations = iterations;
      const bool falls = slope(foot) < 0, ends = falls ? t == most : t == least;
      foot.inside = !ends || foot.residual <= 1e-9 * foot.radius;
      const double scale = foot.radius + 1e-3 * length(pencil_.point);
      if (ends || foot.residual <= 1e-13 * scale || iterations >= most_iterations) return foot;
      (falls ? low : high) = t;
      const double next = newton(foot, t), half = low + (high - low) / 2;
      bool& end_seen = falls ? most_seen : least_seen;
      if (next > low && next < high)
        t = next;
      else if (!end_seen)
        t = falls ? most : least, end_seen = true;
      else
        t = half;
      if (t == foot.t || (t == half && (half == low || half == high))) return foot;
    }
  }

 private:
  static constexpr int most_iterations = 80;

  GABARIT_HD CurveFoot at(double t) const {
    CurveFoot foot;
    foot.t = t;
    foot.curve = curve_point(brep_, curve_, t);
    const PencilBall ball = ball_of(pencil_, foot.curve.p);
    foot.radius = ball.radius;
    const double speed = length(foot.curve.d);
    if (ball.ahead > 0 && speed > 0) foot.residual = std::fabs(dot(ball.arm, foot.curve.d)) / speed;
    return foot;
  }

  // Of the same sign as that of the radius; behind the tangent plane it falls towards the plane.
  GABARIT_HD double slope(const CurveFoot& foot) const {
    const Vec3d q = foot.curve.p - pencil_.point;
    if (!(dot(pencil_.direction, q) > 0)) return -dot(pencil_.direction, foot.curve.d);
    return 2 * dot(pencil_.direction, q) * dot(q, foot.curve.d) -
           squared_length(q) * dot(pencil_.direction, foot.curve.d);
  }

  GABARIT_HD double newton(const CurveFoot& foot, double t) const {
    const PencilBall ball = ball_of(pencil_, foot.curve.p);
    if (!(ball.ahead > 0)) return std::numeric_limits<double>::infinity();
    const Vec3d& c = foot.curve.d;
    const double g = dot(ball.arm, c);
    const double second =
        squared_length(c) + dot(ball.arm, foot.curve.dd) - 2 * g / ball.ahead * dot(pencil_.direction, c);
    return second > 0 ? t - g / second : std::numeric_limits<double>::infinity();
  }

  const BrepView& brep_;
  const Curve& curve_;
  const Pencil& pencil_;
};

}  // namespace gabarit
