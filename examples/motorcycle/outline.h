// Plane curves: profiles and outlines of the vehicle's parts, made of lines, arcs and cubic spline spans.
#pragma once

#include <vector>

namespace gabarit::motorcycle {

struct Vec2 {
  double x = 0, y = 0;

  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
};

// A corner of a polygon and the radius (mm) that rounds it; 0: sharp.
struct Corner {
  double x, y;
  double radius = 0;
};

// Piece i of the curve covers the parameters [i, i + 1].
class Outline {
 public:
  // A polygon whose corners are rounded by tangent arcs. The radii must fit the sides: an arc takes
  // radius · tan(turn / 2) of each of the two sides, throws std::invalid_argument when that is too much.
  // The ends of an open one stay where they are; their radii are not used.
  static Outline closed(const std::vector<Corner>& corners);
  static Outline open(const std::vector<Corner>& corners);
  // The closed uniform cubic B-spline of these control points; curvature is continuous.
  static Outline spline(const std::vector<Vec2>& controls);
  static Outline circle(double radius);
  static Outline rectangle(double width, double height, double corner_radius);  // about the origin

  bool is_spline() const { return pieces_.front().kind == Kind::span; }
  int pieces() const { return static_cast<int>(pieces_.size()); }
  Vec2 at(double t) const;
  Vec2 normal(double t) const;  // unit, to the right of the direction: outward when counter-clockwise

 private:
  enum class Kind { line, arc, span };
  struct Piece {
    Kind kind;
    Vec2 a, b, c, d;  // line: a to b; arc: centre a, b = {radius, -}; c = {from, sweep}; span: four controls
  };
  static Outline rounded(const std::vector<Corner>& corners, bool closed);
  const Piece& piece(double t, double& fraction) const;

  std::vector<Piece> pieces_;
};

}  // namespace gabarit::motorcycle
