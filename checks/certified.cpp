#include "checks/certified.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

namespace gabarit {

using Exact = CGAL::Exact_rational;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// A sum of products of a few differences carries a relative error of some 1e-15 of its terms; beyond this it
// is certain.
static constexpr double filter = 1e-13;

static int sign(double difference, double magnitude) {
  return difference > filter * magnitude ? 1 : difference < -filter * magnitude ? -1 : 0;
}

int compare_distance(Point2 v, Point2 w, double reach) {
  const Point2 d = w - v;
  const double squared = dot(d, d);
  const double magnitude = squared + reach * reach + std::abs(v.x * w.x) + std::abs(v.y * w.y);
  if (const int certain = sign(squared - reach * reach, magnitude); certain != 0) return certain;
  const Exact x = Exact(w.x) - Exact(v.x);
  const Exact y = Exact(w.y) - Exact(v.y);
  return static_cast<int>(CGAL::compare(x * x + y * y, Exact(reach) * Exact(reach)));
}

int compare_line_distance(Point2 v, Point2 a, Point2 b, double reach) {
  const Point2 ab = b - a;
  const double area = cross(ab, v - a);
  const double squared = dot(ab, ab) * reach * reach;
  const double magnitude = area * area + squared + dot(ab, ab) * (dot(v, v) + dot(a, a));
  if (const int certain = sign(area * area - squared, magnitude); certain != 0) return certain;
  const Exact x = Exact(b.x) - Exact(a.x);
  const Exact y = Exact(b.y) - Exact(a.y);
  const Exact exact_area = x * (Exact(v.y) - Exact(a.y)) - y * (Exact(v.x) - Exact(a.x));
  return static_cast<int>(
      CGAL::compare(exact_area * exact_area, (x * x + y * y) * Exact(reach) * Exact(reach)));
}

int side_of_line(Point2 a, Point2 b, Point2 c) {
  return static_cast<int>(
      CGAL::orientation(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y), Kernel::Point_2(c.x, c.y)));
}

}  // namespace gabarit
