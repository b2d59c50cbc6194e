// Where the balls of a pencil touch planes, spheres, cylinders, cones and tori, and the smallest of them on
// the line along which the normal of such a surface turns away by just so much (not of tori): in closed form.
// The distance of the ball's centre from each of these is known without a foot; that it is the radius is an
// equation of first or second degree.
#pragma once

#include "gpu/tangent_ball.h"
#include "model/brep_foot.h"

namespace gabarit {

// Places on a surface, not yet known to be inside of a face.
struct ClosedFeet {
  static constexpr int most = 8;
  Parameters at[most];
  int count = 0;

  GABARIT_HD void add(double u, double v) {
    if (count < most && std::isfinite(u) && std::isfinite(v)) at[count++] = {u, v};
  }
};

GABARIT_HD inline bool has_closed_rim(SurfaceKind kind) {
  return kind == SurfaceKind::plane || kind == SurfaceKind::sphere || kind == SurfaceKind::cylinder ||
         kind == SurfaceKind::cone;
}
GABARIT_HD inline bool has_closed_feet(SurfaceKind kind) {
  return has_closed_rim(kind) || kind == SurfaceKind::torus;
}

// The parameter of a cone's apex.
GABARIT_HD inline double apex_of(const Surface& cone) { return -cone.radius / sine(cone.minor); }

// A vector in the axes of a surface: along z, and across it by its components along x and y.
struct AxialVector {
  double x, y, z;
  GABARIT_HD AxialVector(const Axes& axes, const Vec3d& v)
      : x(dot(v, axes.x)), y(dot(v, axes.y)), z(dot(v, axes.z)) {}
  GABARIT_HD double across(const AxialVector& b) const { return x * b.x + y * b.y; }
  GABARIT_HD double azimuth() const { return angle_of(y, x); }
};

// The solutions of a·t² + 2b·t + c = 0, also of first degree; not finite where there is none.
struct QuadraticRoots {
  double t[2];
  GABARIT_HD QuadraticRoots(double a, double b, double c) {
    const double inside = b * b - a * c, tiny = 1e-12 * (b * b + std::fabs(a * c));
    const double root = std::sqrt(inside > 0 ? inside : inside > -tiny ? 0.0 : inside);
    const double q = -(b < 0 ? b - root : b + root);
    t[0] = q / a, t[1] = c / q;
  }
};

class ClosedFootSearch {
 public:
  // `size`: of the model, mm.
  GABARIT_HD ClosedFootSearch(const Surface& surface, const Pencil& pencil, double size)
      : surface_(surface), pencil_(pencil), size_(size) {}

  GABARIT_SEPARATE GABARIT_HD void add_feet(ClosedFeet& feet) const {
    switch (surface_.kind) {
      case SurfaceKind::plane: return on_plane(feet);
      case SurfaceKind::sphere: return on_sphere(feet);
      case SurfaceKind::cylinder: return on_cylinder(feet);
      case SurfaceKind::torus: return on_torus(feet);
      default: return on_cone(feet);
    }
  }

  // On the line where normal · axis is `least`, for the outward normal of the face; axis is the pencil's
  // direction or against it.
  GABARIT_SEPARATE GABARIT_HD void add_rim(const Face& face, const Vec3d& axis, double least,
                                           ClosedFeet& feet) const {
    const Axes& axes = surface_.axes;
    const double hand = dot(cross(axes.x, axes.y), axes.z) < 0 ? -face.sign : face.sign;
    const double middle = (face.range.v0 + face.range.v1) / 2;
    switch (surface_.kind) {
      case SurfaceKind::torus: return;
      case SurfaceKind::plane: return;  // it does not turn
      case SurfaceKind::sphere: return rim_on_sphere(axis, hand, least, feet);
      case SurfaceKind::cylinder: return add_lines(face, axis, least * hand, 0, 1, feet);
      default: break;
    }
    const auto [sine, cosine] = sine_cosine(surface_.minor);
    const double nappe = surface_.radius + middle * sine < 0 ? -hand : hand;
    add_lines(face, axis, least * nappe, sine, cosine, feet);
  }

 private:
  // None on the pencil's own tangent plane.
  GABARIT_HD void on_plane(ClosedFeet& feet) const {
    const Axes& axes = surface_.axes;
    Vec3d m = normalized(cross(axes.x, axes.y));
    double height = dot(m, axes.origin - pencil_.point);
    if (height < 0) height = -height, m = -m;
    const double spread = 1 + dot(m, pencil_.direction);
    if (!(height > 1e-12 * size_) || !(spread > 1e-12)) return;
    const Vec3d p = pencil_.point + height / spread * (pencil_.direction + m) - axes.origin;
    feet.add(dot(p, axes.x), dot(p, axes.y));
  }

  // The distance of the centres is the sum or the difference of the radii: linear in the ball's. Of a sphere
  // that the point lies on all points are equally near, or none: the opposite one stands for all.
  GABARIT_HD void on_sphere(ClosedFeet& feet) const {
    const Vec3d c = pencil_.point - surface_.axes.origin;
    const double r = surface_.radius, outside = r * r - squared_length(c);
    for (const double way : {-1.0, 1.0}) {
      const double t = outside / (2 * (dot(c, pencil_.direction) - way * r));
      if (!(t > 0)) continue;
      const Vec3d m = c + t * pencil_.direction;
      add_on_sphere(r + way * t > 0 ? m : -m, feet);
    }
    if (std::fabs(outside) < own * r * r) add_on_sphere(-c, feet);
  }
  GABARIT_HD void add_on_sphere(const Vec3d& towards, ClosedFeet& feet) const {
    const AxialVector p(surface_.axes, towards);
    feet.add(p.azimuth(), angle_of(p.z, std::sqrt(p.x * p.x + p.y * p.y)));
  }

  // The distance of the centre from the axis is the sum or the difference of the radii.
  GABARIT_HD void on_cylinder(ClosedFeet& feet) const {
    const AxialVector c(surface_.axes, pencil_.point - surface_.axes.origin),
        d(surface_.axes, pencil_.direction);
    const double r = surface_.radius, inside = c.across(c) - r * r;
    for (const double way : {-1.0, 1.0}) {
      const QuadraticRoots roots(-d.z * d.z, c.across(d) - way * r, inside);
      for (const double t : roots.t) {
        if (!(t > 0)) continue;
        const double turned = r + way * t < 0 ? -1 : 1;
        feet.add(angle_of(turned * (c.y + t * d.y), turned * (c.x + t * d.x)), c.z + t * d.z);
      }
    }
    if (std::fabs(inside) < own * r * r) feet.add(angle_of(-c.y, -c.x), c.z);
  }

  // The same with the distance from a line of the cone, in the plane of the axis and the centre.
  GABARIT_HD void on_cone(ClosedFeet& feet) const {
    const auto [sine, cosine] = sine_cosine(surface_.minor);
    const double apex = apex_of(surface_);
    const AxialVector c(surface_.axes,
                        pencil_.point - surface_.axes.origin - apex * cosine * surface_.axes.z),
        d(surface_.axes, pencil_.direction);
    const double down = sine * c.z, aside = cosine * cosine * c.across(c);
    const double inside = aside - down * down;
    for (const double way : {-1.0, 1.0}) {
      const double slope = way + sine * d.z;
      const QuadraticRoots roots(cosine * cosine * d.across(d) - slope * slope,
                                 cosine * cosine * c.across(d) - slope * down, inside);
      for (const double t : roots.t) {
        if (!(t > 0)) continue;
        const double turned = slope * t + down < 0 ? -1 : 1;
        const double x = turned * (c.x + t * d.x), y = turned * (c.y + t * d.y);
        feet.add(angle_of(y, x), apex + turned * sine * std::sqrt(x * x + y * y) + cosine * (c.z + t * d.z));
      }
    }
    if (std::fabs(inside) < own * aside) feet.add(angle_of(-c.y, -c.x), apex + c.z / cosine);
  }

  // The distance of the centre from the circle in the middle of the tube: squared twice it stays of second
  // degree, as the radius itself drops out.
  GABARIT_HD void on_torus(ClosedFeet& feet) const {
    const AxialVector c(surface_.axes, pencil_.point - surface_.axes.origin),
        d(surface_.axes, pencil_.direction);
    const double large = surface_.radius, small = surface_.minor, four = 4 * large * large;
    const double square = c.across(c) + c.z * c.z, along = c.across(d) + c.z * d.z;
    const double constant = square + large * large - small * small;
    for (const double way : {-1.0, 1.0}) {
      const double slope = 2 * (along - way * small);
      const QuadraticRoots roots(slope * slope - four * d.across(d), slope * constant - four * c.across(d),
                                 constant * constant - four * c.across(c));
      for (const double t : roots.t)
        if (t > 0) add_on_torus(c, d, t, constant + slope * t < 0, small + way * t, feet);
    }
    const double x = std::sqrt(c.across(c)), off = std::sqrt((x - large) * (x - large) + c.z * c.z) - small;
    if (std::fabs(off) < own * small) feet.add(c.azimuth(), angle_of(-c.z, large - x));
  }
  // `far`: the circle is nearest on the other side of the axis.
  GABARIT_HD void add_on_torus(const AxialVector& c, const AxialVector& d, double t, bool far,
                               double distance, ClosedFeet& feet) const {
    const double x = c.x + t * d.x, y = c.y + t * d.y, z = c.z + t * d.z;
    const double turned = far ? -1 : 1, out = distance < 0 ? -1 : 1;
    feet.add(angle_of(turned * y, turned * x),
             angle_of(out * z, out * (turned * std::sqrt(x * x + y * y) - surface_.radius)));
  }

  // Along the circle only the distance from the point changes.
  GABARIT_HD void rim_on_sphere(const Vec3d& axis, double hand, double least, ClosedFeet& feet) const {
    if (!(least > -1 && least < 1)) return;
    const Vec3d c = pencil_.point - surface_.axes.origin;
    const Vec3d aside = c - dot(c, axis) * axis;
    const Vec3d any = std::fabs(axis.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const bool on_axis = !(squared_length(aside) > 1e-24 * surface_.radius * surface_.radius);
    const Vec3d way = normalized(on_axis ? cross(axis, any) : aside);
    add_on_sphere(hand * least * axis + std::sqrt(1 - least * least) * way, feet);
  }

  // The normal of a cylinder or cone is cosine·e(u) - sine·z: it is the same along its lines. `facing` is
  // what normal · axis is on the wanted ones.
  GABARIT_HD void add_lines(const Face& face, const Vec3d& axis, double facing, double sine, double cosine,
                            ClosedFeet& feet) const {
    const AxialVector a(surface_.axes, axis);
    const double ratio = (facing + sine * a.z) / (cosine * std::sqrt(a.across(a)));
    if (!(std::fabs(ratio) < 1 + slack)) return;
    const double turn = arc_cosine(ratio > 1 ? 1.0 : ratio < -1 ? -1.0 : ratio), middle = a.azimuth();
    add_on_line(face, middle - turn, sine, cosine, feet);
    add_on_line(face, middle + turn, sine, cosine, feet);
  }
  GABARIT_HD void add_on_line(const Face& face, double u, double sine, double cosine,
                              ClosedFeet& feet) const {
    const Axes& axes = surface_.axes;
    const SineCosine turn = sine_cosine(u);
    const Vec3d e = turn.cosine * axes.x + turn.sine * axes.y, along = sine * e + cosine * axes.z;
    const Vec3d start = axes.origin + surface_.radius * e - pencil_.point;
    const ParameterBox& r = face.range;
    double at = 0;
    ball_through_segment(pencil_.direction, start + r.v0 * along, start + r.v1 * along, &at);
    feet.add(u, r.v0 + at * (r.v1 - r.v0));
  }

  static constexpr double own = 1e-9;    // as good as on the surface itself
  static constexpr double slack = 1e-6;  // as for normals that just count

  const Surface& surface_;
  const Pencil& pencil_;
  double size_;
};

}  // namespace gabarit
