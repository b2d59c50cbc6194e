#include "model/monotone_cuts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/bernstein.h"

namespace gabarit {
namespace {

constexpr double pi = std::numbers::pi;

// `root` and what lies whole periods from it.
void add_in_every_turn(double root, double period, double from, double to, std::vector<double>& cuts) {
  const double first = std::ceil((from - root) / period);
  for (double k = first; root + k * period < to; ++k) cuts.push_back(root + k * period);
}

// Of a·c(t) + b·s(t), where c and s are what the kind of conic says.
void add_conic_roots(const Curve& c, double a, double b, double from, double to, std::vector<double>& cuts) {
  switch (c.kind) {
    case CurveKind::circle:
      add_in_every_turn(std::atan2(c.radius * b, c.radius * a), pi, from, to, cuts);
      break;
    case CurveKind::ellipse:
      add_in_every_turn(std::atan2(c.minor * b, c.radius * a), pi, from, to, cuts);
      break;
    case CurveKind::parabola:
      if (a != 0) cuts.push_back(-2 * c.radius * b / a);
      break;
    case CurveKind::hyperbola:
      if (std::abs(c.minor * b) < std::abs(c.radius * a))
        cuts.push_back(std::atanh(-c.minor * b / (c.radius * a)));
      break;
    default: break;
  }
}

// Of the derivative of one coordinate over all spans.
template <class Coordinate>
void add_spline_roots(const Brep& brep, const Curve& c, Coordinate coordinate, std::vector<double>& cuts) {
  SignChanges changes;
  const double* const knots = brep.knots.data() + c.first_knot;
  for (int span = c.degree; span < c.pole_count; ++span) {
    if (!(knots[span] < knots[span + 1])) continue;
    const std::vector<Pole> poles = bezier_poles(brep, c, span);
    // Relative to the first point, so that a curve far from the origin keeps its digits.
    const double origin = coordinate(poles[0]) / poles[0].w;
    std::vector<double> a, w;
    double size = 0, weight = 0;
    for (const Pole& p : poles) {
      size = std::max(size, std::abs(coordinate(p)));
      weight = std::max(weight, std::abs(p.w));
      a.push_back(coordinate(p) - origin * p.w), w.push_back(p.w);
    }
    changes.add(quotient_slope(a, w), knots[span], knots[span + 1], 1e-15 * c.degree * size * weight);
  }
  cuts.insert(cuts.end(), changes.at().begin(), changes.at().end());
}

std::vector<double> spline_cuts(const Brep& brep, const Curve& c, double from, double to) {
  std::vector<double> once, cuts;
  add_spline_roots(
      brep, c, [](const Pole& p) { return p.x; }, once);
  add_spline_roots(
      brep, c, [](const Pole& p) { return p.y; }, once);
  if (!c.periodic) return once;
  once.push_back(c.first);  // where the last span meets the first
  for (const double root : once) add_in_every_turn(root, c.last - c.first, from, to, cuts);
  return cuts;
}

}  // namespace

std::vector<double> monotone_cuts(const Brep& brep, const Curve& c, double from, double to) {
  std::vector<double> cuts;
  if (c.kind == CurveKind::spline) {
    cuts = spline_cuts(brep, c, from, to);
  } else {
    add_conic_roots(c, c.axes.x.x, c.axes.y.x, from, to, cuts);
    add_conic_roots(c, c.axes.x.y, c.axes.y.y, from, to, cuts);
  }
  std::erase_if(cuts, [&](double t) { return !(t > from && t < to); });
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

}  // namespace gabarit
