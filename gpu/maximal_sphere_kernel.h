// The query behind maximal_spheres: the smallest ball that a contact leaves, by one best-first search.
#pragma once

#include "gpu/contact_cap.h"
#include "gpu/maximal_sphere.h"
#include "gpu/sphere_culling.h"
#include "gpu/tangent_ball.h"

namespace gabarit {

// Whether the surface leaves an edge or vertex away from a ball that reaches it in the unit direction
// `outward`, in every direction of its fan.
GABARIT_HD inline bool leaves(const BvhView& tree, std::uint32_t fan, const Vec3d& outward) {
  for (std::uint32_t i = tree.fan_first[fan]; i < tree.fan_first[fan + 1]; ++i) {
    const Vec3f w = tree.fan_directions[i];
    if (static_cast<double>(w.x) * outward.x + static_cast<double>(w.y) * outward.y +
            static_cast<double>(w.z) * outward.z <
        -fan_tolerance)
      return false;
  }
  return true;
}

GABARIT_HD inline double dot(const Vec3f& a, const Vec3d& b) {
  return static_cast<double>(a.x) * b.x + static_cast<double>(a.y) * b.y + static_cast<double>(a.z) * b.z;
}

// What a facet's rounded normal tells without looking at more than one corner.
struct FacetGlance {
  double facing;  // normal · direction
  double depth;   // of the facet's plane from the point, at least
  double spread;  // the ball that is tangent to the plane is at least depth / spread large
  GABARIT_HD FacetGlance(const Primitive& p, const Vec3d& direction, const Vec3d& corner)
      : facing(dot(p.normal, direction)) {
    const double height = dot(p.normal, corner);
    const double rounding = 3e-7 * (std::fabs(corner.x) + std::fabs(corner.y) + std::fabs(corner.z));
    depth = std::fabs(height) - rounding;
    spread = 1 + (height < 0 ? -facing : facing) + 1e-6;
  }
  // Whether a ball of this radius can reach the plane.
  GABARIT_HD bool reached_by(double radius) const { return depth <= radius * spread; }
};

class MaximalSphere {
 public:
  GABARIT_HD MaximalSphere(const BvhView& tree, const SphereOptions& options, const SphereQuery& query)
      : tree_(tree), options_(options), query_(query), culling_(tree, options, query.point, query.direction) {
    set_reach(options.greatest_radius);
  }

  GABARIT_HD float limit() const { return limit_; }

  template <class Boxes>
  GABARIT_HD void within(const Boxes& boxes, EightFloats& lower) {
    if (++visits_ > patience) limit_ = culling_.probe() / gap_.widen();
    culling_.within(boxes, lower);
  }

  GABARIT_HD void visit(const Primitive& p) {
    if (p.id == query_.own || &p == guess_) return;
    if (p.is_facet())
      visit_facet(p);
    else
      visit_feature(p);
  }

  // What may be the contact, before the search: the better the guess, the less there is to look at.
  GABARIT_HD void start_from(const Primitive& guess) {
    visit(guess);
    guess_ = &guess;
  }

  // The lower bound is that of the arithmetic alone.
  GABARIT_HD SphereContact result() const {
    SphereContact found = best_;
    found.lower = reach_ / static_cast<double>(gap_.factor());
    return found;
  }

  // Where in the tree the contact is; a good first guess for a neighbouring query.
  GABARIT_HD const Primitive* touched() const { return touched_; }

 private:
  static constexpr int patience = 192;

  GABARIT_HD void visit_facet(const Primitive& p) {
    const Vec3d d = query_.direction;
    if (dot(p.normal, d) < -options_.cos_separation - 1e-6) return;
    const Vec3d a = tree_.corner(p, 0) - query_.point;
    if (!FacetGlance(p, d, a).reached_by(reach_)) return;
    const Vec3d b = tree_.corner(p, 1) - query_.point, c = tree_.corner(p, 2) - query_.point;
    if (is_shallow(a, b, c)) return;
    record(p, ball_through_triangle(d, a, b, c, reach_));
  }

  // Facets in the plane of the query: what a ball within reach touches so little ahead lies within the floor.
  GABARIT_HD bool is_shallow(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
    const double ha = dot(query_.direction, a), hb = dot(query_.direction, b), hc = dot(query_.direction, c);
    const double h = ha > hb ? ha : hb, deepest = h > hc ? h : hc;
    return deepest <= 0 || 4 * deepest * reach_ < options_.contact_floor * options_.contact_floor;
  }

  GABARIT_HD void visit_feature(const Primitive& p) {
    const Vec3d a = tree_.corner(p, 0) - query_.point;
    TangentBall ball;
    if (p.corner[0] == p.corner[1]) {
      ball = ball_through_point(query_.direction, a);
    } else {
      double at = 0;
      ball = ball_through_segment(query_.direction, a, tree_.corner(p, 1) - query_.point, &at);
      if (at <= 0 || at >= 1) return;  // the vertices speak for themselves
    }
    if (!(ball.radius <= reach_)) return;
    const Vec3d outward = (ball.contact - ball.radius * query_.direction) / ball.radius;
    if (dot(outward, query_.direction) < -options_.cos_separation - 1e-6) return;
    if (leaves(tree_, p.corner[2], outward)) record(p, ball);
  }

  GABARIT_HD void record(const Primitive& p, const TangentBall& ball) {
    const double t = ball.radius;
    if (!(t <= reach_)) return;
    const double qq = squared_length(ball.contact);
    if (!(qq > options_.contact_floor * options_.contact_floor)) return;
    const double upper = farthest(p, ball, qq);
    if (upper < best_.upper) best_.upper = upper;
    if (t == best_.radius && p.id > best_.primitive) return;
    best_.radius = t;
    best_.contact = query_.point + ball.contact;
    best_.primitive = p.id;
    touched_ = &p;
    if (t < reach_) set_reach(t);
  }

  // The ball that goes through the contact when surface and contact are apart by the sags more and the
  // direction is tilted for the worst.
  GABARIT_HD double farthest(const Primitive& p, const TangentBall& ball, double qq) const {
    const double s = static_cast<double>(query_.sag) + static_cast<double>(p.sag);
    const double tilt = query_.tilt;
    if (s == 0 && tilt == 0) return ball.radius;
    const double h = dot(query_.direction, ball.contact);
    if (!(h > s)) return std::numeric_limits<double>::infinity();
    const double aside = std::sqrt(qq > h * h ? qq - h * h : 0.0) / h;
    // Of an angle under 0.5 the series errs by less than 1e-4 of it, on the safe side here.
    const double turned = 1 - 0.5 * tilt * tilt - aside * tilt;
    if (!(turned > 0)) return std::numeric_limits<double>::infinity();
    return ball.radius * (h / (h - s)) / turned;
  }

  GABARIT_HD void set_reach(double reach) {
    reach_ = reach;
    culling_.set_radius(reach);
    limit_ = culling_.probe() / gap_.factor();
  }

  const BvhView& tree_;
  const SphereOptions& options_;
  const SphereQuery& query_;
  SphereCulling<false> culling_;
  SphereContact best_;
  double reach_ = 0;
  const Primitive* touched_ = nullptr;
  const Primitive* guess_ = nullptr;
  SearchGap gap_;
  float limit_ = 0;
  int visits_ = 0;
};

}  // namespace gabarit
