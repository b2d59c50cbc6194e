#include "checks/curvature_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "gpu/point2.h"

namespace gabarit {

namespace {

using Corners2 = std::array<Point2, 3>;  // of a facet, unfolded into the plane of the facet asked about

// A symmetric matrix.
struct Shape {
  double xx = 0, xy = 0, yy = 0;
};

// turn = tr(H M) = xx Hxx + 2 xy Hxy + yy Hyy.
struct Equation {
  Shape m;
  double turn, noise;
  double width;  // mean height of the two facets over the edge, mm: the turn is about curvature times this
  bool concave;
};

struct Solution {
  Shape h;
  double sensitivity = 0;
};

using Matrix3 = std::array<std::array<double, 3>, 3>;

double determinant(const Matrix3& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

std::array<double, 3> solve_linear(const Matrix3& a, const std::array<double, 3>& b) {
  const double d = determinant(a);
  if (!(d > 0)) return {};
  std::array<double, 3> x{};
  for (std::size_t k = 0; k < 3; ++k) {
    Matrix3 replaced = a;
    for (std::size_t r = 0; r < 3; ++r) replaced[r][k] = b[r];
    x[k] = determinant(replaced) / d;
  }
  return x;
}

constexpr double hollow = 0.1;         // rad: edges that turn inwards by more may belong to something else
constexpr double usual_misfit = 0.01;  // of an equation, as a share of the curvature
constexpr std::size_t most_equations = 48;

class Equations {
 public:
  Equations(const TriangleMesh& mesh, const Folds& folds, FacetId f);

  bool resolved() const { return resolved_; }
  Solution solve(bool with_concave) const;
  double worst_residual(const Shape& h, bool with_concave) const;
  double steepest() const;
  bool has_concave() const;
  std::size_t size() const { return size_; }

 private:
  void add(const Fold& fold, FacetId f, const Corners2& here);
  Corners2 unfold(FacetId f, const Fold& fold, const Corners2& here) const;

  const TriangleMesh* mesh_;
  std::array<Equation, most_equations> equations_{};
  std::size_t size_ = 0;
  bool resolved_ = false;
};

std::size_t after(std::size_t corner) { return corner == 2 ? 0 : corner + 1; }

Corners2 in_own_plane(const TriangleMesh& mesh, FacetId f) {
  const FacetEdge e = facet_edge(mesh, f, 0);
  return {Point2{0, 0}, Point2{e.length, 0}, Point2{e.foot, e.height}};
}

// The part of M that belongs to one facet: its apex is `foot` along the unit direction `u` from the middle of
// the shared edge and `height` beyond it; `away` says on which side (1: left of u).
void add_side(Shape& m, Point2 u, double foot, double from, double to, double height, double away) {
  const Point2 n{-u.y, u.x};
  const double nn = 0.5 * height;
  const double en = 0.5 * away * foot;
  const double ee = -0.5 * (foot - from) * (to - foot) / height;
  m.xx += nn * n.x * n.x + 2 * en * n.x * u.x + ee * u.x * u.x;
  m.xy += nn * n.x * n.y + en * (n.x * u.y + n.y * u.x) + ee * u.x * u.y;
  m.yy += nn * n.y * n.y + 2 * en * n.y * u.y + ee * u.y * u.y;
}

double largest_eigenvalue(const Shape& h) {
  return 0.5 * (h.xx + h.yy) + std::sqrt(0.25 * (h.xx - h.yy) * (h.xx - h.yy) + h.xy * h.xy);
}

// The neighbour's edge lies along the facet's; where it only overlaps (a T-junction) it is moved, not
// stretched.
Corners2 Equations::unfold(FacetId f, const Fold& fold, const Corners2& here) const {
  const FacetEdge mine = facet_edge(*mesh_, f, fold.edge);
  const FacetEdge theirs = facet_edge(*mesh_, fold.facet, fold.other);
  const Point2 a = here[fold.edge];
  const Point2 u = (here[after(fold.edge)] - a) * (1 / mine.length);
  const Point2 n{-u.y, u.x};
  const Vec3d along = (mine.to - mine.from) / mine.length;
  const auto place = [&](const Vec3d& p) { return a + u * dot(p - mine.from, along); };
  Corners2 there;
  there[fold.other] = place(theirs.from);
  there[after(fold.other)] = place(theirs.to);
  there[after(after(fold.other))] = place(theirs.apex) - n * theirs.height;
  return there;
}

void Equations::add(const Fold& fold, FacetId f, const Corners2& here) {
  if (size_ == most_equations || !fold.oriented || is_rim_here(fold)) return;
  const FacetEdge mine = facet_edge(*mesh_, f, fold.edge);
  const FacetEdge theirs = facet_edge(*mesh_, fold.facet, fold.other);
  const Point2 u = (here[after(fold.edge)] - here[fold.edge]) * (1 / mine.length);
  const Vec3d along = (mine.to - mine.from) / mine.length;
  const auto place = [&](const Vec3d& p) { return dot(p - mine.from, along); };
  const double a = place(theirs.from);
  const double b = place(theirs.to);
  const double middle = 0.5 * (std::max(0.0, std::min(a, b)) + std::min(mine.length, std::max(a, b)));
  const bool plane_there = fold.convex && !fold.turns_there;
  Equation e{.m = {},
             .turn = 2 * std::sin(0.5 * fold.turn),  // exact for equal chords of a circle
             .noise = fold.noise,
             .width = 0.5 * (mine.height + theirs.height),
             .concave = fold.turn < -hollow};
  add_side(e.m, u, mine.foot - middle, -middle, mine.length - middle, mine.height, 1);
  if (!plane_there) {
    add_side(e.m, u, place(theirs.apex) - middle, std::min(a, b) - middle, std::max(a, b) - middle,
             theirs.height, -1);
  }
  if (fold.convex && !plane_there) resolved_ = true;
  equations_[size_++] = e;
}

Equations::Equations(const TriangleMesh& mesh, const Folds& folds, FacetId f) : mesh_(&mesh) {
  const Corners2 here = in_own_plane(mesh, f);
  for (const Fold& own : folds.of(f)) add(own, f, here);
  for (const Fold& own : folds.of(f)) {
    if (!own.oriented || is_rim_here(own) || is_rim_there(own)) continue;
    const Corners2 there = unfold(f, own, here);
    for (const Fold& next : folds.of(own.facet)) {
      if (next.edge != own.other) add(next, own.facet, there);
    }
  }
}

double Equations::steepest() const {
  double largest = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    largest = std::max(largest, (equations_[i].turn - equations_[i].noise) / equations_[i].width);
  }
  return largest;
}

bool Equations::has_concave() const {
  return std::any_of(equations_.begin(), equations_.begin() + static_cast<std::ptrdiff_t>(size_),
                     [](const Equation& e) { return e.concave; });
}

// Cramer's rule on the normal equations; a ridge far below anything measured keeps them solvable.
Solution Equations::solve(bool with_concave) const {
  Matrix3 a{};
  std::array<double, 3> b{};
  for (std::size_t i = 0; i < size_; ++i) {
    const Equation& e = equations_[i];
    if (e.concave && !with_concave) continue;
    const std::array<double, 3> row{e.m.xx, 2 * e.m.xy, e.m.yy};
    constexpr double curvature_noise = 0.01;  // 1/mm: noise below this does not matter
    const double off = e.noise / curvature_noise;
    const double weight = 1 / (e.width * e.width + off * off);
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) a[r][c] += weight * row[r] * row[c];
      b[r] += weight * row[r] * e.turn;
    }
  }
  const double ridge = 1e-9 * (a[0][0] + a[1][1] + a[2][2]);
  for (std::size_t r = 0; r < 3; ++r) a[r][r] += ridge;
  const std::array<double, 3> x = solve_linear(a, b);
  Solution s{.h = {x[0], x[1], x[2]}};
  // The direction of the largest curvature, and how much that curvature changes when every equation is off
  // by 1/mm.
  const double angle = 0.5 * std::atan2(2 * s.h.xy, s.h.xx - s.h.yy);
  const std::array<double, 3> g{std::cos(angle) * std::cos(angle), std::sin(2 * angle),
                                std::sin(angle) * std::sin(angle)};
  const std::array<double, 3> y = solve_linear(a, g);
  s.sensitivity = std::sqrt(std::max(0.0, y[0] * g[0] + y[1] * g[1] + y[2] * g[2]));
  return s;
}

double Equations::worst_residual(const Shape& h, bool with_concave) const {
  double worst = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    const Equation& e = equations_[i];
    if (e.concave && !with_concave) continue;
    const double predicted = e.m.xx * h.xx + 2 * e.m.xy * h.xy + e.m.yy * h.yy;
    worst = std::max(worst, (std::fabs(e.turn - predicted) - e.noise) / e.width);
  }
  return worst;
}

}  // namespace

CurvatureFit fit_curvature(const TriangleMesh& mesh, const Folds& folds, FacetId f) {
  const Equations equations(mesh, folds, f);
  if (equations.size() == 0) return {.doubt = std::numeric_limits<double>::infinity()};
  const auto fitted = [&](bool with_concave) {
    const Solution s = equations.solve(with_concave);
    const double curvature = largest_eigenvalue(s.h);
    return CurvatureFit{.curvature = curvature,
                        .doubt = equations.worst_residual(s.h, with_concave) +
                                 usual_misfit * std::fabs(curvature) * s.sensitivity,
                        .steepest = equations.steepest(),
                        .resolved = equations.resolved()};
  };
  const CurvatureFit all = fitted(true);
  if (!equations.has_concave()) return all;
  const CurvatureFit convex = fitted(false);
  return convex.doubt < 0.5 * all.doubt ? convex : all;
}

}  // namespace gabarit
