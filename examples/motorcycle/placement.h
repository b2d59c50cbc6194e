// Where parts stand and how they are bent: maps from the coordinates in which a part is drawn to the
// vehicle's.
#pragma once

#include <vector>

#include "examples/motorcycle/surface.h"

namespace gabarit::motorcycle {

// The part's z axis points along `z`, its x axis as near to `x` as that allows.
Placement stand(const Vec3d& origin, const Vec3d& z, const Vec3d& x);
// First `inner`, then `outer`.
Placement placed(Placement inner, Placement outer);

// A plate's middle surface drawn in the x-y plane becomes part of a torus: x runs around the origin at
// `radius` in the x-z plane, y around a circle of `cross_radius` that lies inside (a barrel). Distances along
// z and the radii of roundings stay true to within thickness / radius. An infinite cross radius gives a
// cylinder.
Placement barrel(double radius, double cross_radius);
// The plate's middle surface becomes z = (bend_x x² + bend_y y²) / 2 + twist x y; z is measured along its
// normal.
Placement draped(double bend_x, double bend_y, double twist);

// A corner of a wire and the radius it is bent by.
struct Bend {
  Vec3d at;
  double radius = 0;
};

// A line of straights and tangent arcs. Cross-sections turn with the bends and never about the line.
class Path {
 public:
  // Throws std::invalid_argument when an arc does not fit its straights. `x` is where the x axis of the first
  // cross-section points to (made perpendicular).
  Path(const std::vector<Bend>& bends, const Vec3d& x);

  double length() const { return starts_.back(); }
  // Where straights and arcs meet, from 0 to length().
  const std::vector<double>& joints() const { return starts_; }
  // Cross-sections drawn in x-y, z along the line; beyond the ends it goes on straight.
  Vec3d at(const Vec3d& local) const;

 private:
  struct Frame {
    Vec3d origin, x, y, z;
  };
  struct Piece {
    Frame start;
    double radius;  // 0: straight
    Vec3d inward;   // unit, to the arc's centre
  };
  void add(double length, double radius, const Vec3d& inward);
  static Frame advanced(const Piece& piece, double s);

  std::vector<Piece> pieces_;
  std::vector<double> starts_;
  Frame end_;
};

}  // namespace gabarit::motorcycle
