// How small the ball may truly be: the surfaces within their sags, the direction within its tilt, the point
// anywhere within its spacing. A second search, as it has to look at more than the first.
#pragma once

#include "gpu/maximal_sphere_kernel.h"

namespace gabarit {

class SphereLowerBound {
 public:
  // `known`: a ball that is certain to be no smaller than the answer. Primitives carry their sags in the
  // boxes of the tree.
  GABARIT_HD SphereLowerBound(const BvhView& tree, const SphereOptions& options, const SphereQuery& query,
                              double known)
      : tree_(tree),
        options_(options),
        query_(query),
        sag_(query.sag),
        spacing_(query.spacing),
        tilt_(query.tilt),
        least_(known),
        culling_(tree, options, query.point, query.direction,
                 {query.sag * (1 + 1e-6F), query.spacing * (1 + 1e-6F), query.tilt}) {
    shrink();
  }

  GABARIT_HD float limit() const { return limit_; }

  template <class Boxes>
  GABARIT_HD void within(const Boxes& boxes, EightFloats& lower) {
    if (++visits_ > patience) limit_ = culling_.probe() / gap_.widen();
    culling_.within(boxes, lower);
  }

  GABARIT_HD void visit(const Primitive& p) {
    if (p.id == query_.own || !(limit_ > 0) || &p == contact_) return;
    const auto corner = [&](int i) { return tree_.corner(p, i) - query_.point; };
    if (!p.is_facet()) return visit_feature(p, corner(0), corner(1));
    if (dot(p.normal, query_.direction) < -options_.cos_separation - 1e-6) return;
    const Vec3d a = corner(0);
    if (reached(FacetGlance(p, query_.direction, a), p))
      visit_facet(a, corner(1), corner(2), static_cast<double>(p.sag));
  }

  // The contact of the ball, before the search.
  GABARIT_HD void start_from(const Primitive& contact) {
    visit(contact);
    contact_ = &contact;
  }

  GABARIT_HD double result() const {
    const double low = least_ / static_cast<double>(gap_.factor());
    return low > 0 ? low : 0.0;
  }

 private:
  static constexpr int patience = 192;

  GABARIT_HD bool reached(FacetGlance glance, const Primitive& p) const {
    glance.depth -= static_cast<double>(p.sag) + sag_;
    const double rest = 1 - glance.facing * glance.facing;
    const double across = std::sqrt(rest > 0 ? rest : 0.0) + 1e-3;
    glance.depth -= spacing_ * across;
    glance.spread += across * tilt_ + 0.5 * tilt_ * tilt_;
    return glance.reached_by(least_);
  }

  // A point that lies no deeper than this below the tangent plane lies in it, for all that is known.
  GABARIT_HD bool ahead(const Vec3d& q) const {
    const double h = dot(query_.direction, q);
    if (!(h > options_.contact_floor)) return false;
    const double away = tilt_ > 0 ? std::sqrt(squared_length(q)) - spacing_ : 0.0;
    return !(away > 0) || h > options_.contact_floor + tilt_ * away;
  }

  GABARIT_HD void visit_facet(const Vec3d& a, const Vec3d& b, const Vec3d& c, double sag) {
    if (!ahead(a) && !ahead(b) && !ahead(c)) return;
    const double s = sag + sag_;
    const double by_plane = plane_bound(a, b, c, s);
    if (by_plane >= least_) return;
    record(by_plane, inflated(s, [&](const Vec3d& back, double limit) {
             return ball_through_triangle(query_.direction, a + back, b + back, c + back, limit).radius;
           }));
  }

  // The ball that is tangent to the facet's plane, wherever on the plane.
  GABARIT_HD double plane_bound(const Vec3d& a, const Vec3d& b, const Vec3d& c, double s) const {
    const Vec3d raw = cross(b - a, c - a);
    const double area = length(raw);
    if (!(area > 0)) return std::numeric_limits<double>::infinity();
    Vec3d m = raw / area;
    double h = dot(m, a);
    if (h < 0) h = -h, m = -m;
    const double along = dot(m, query_.direction);
    const double across = std::sqrt(along < 1 && along > -1 ? 1 - along * along : 0.0);
    const double spread = 1 + along + across * tilt_ + 0.5 * tilt_ * tilt_;
    const double nearest = h - spacing_ * across - s;
    return spread > 0 && nearest > 0 ? nearest / spread : 0.0;
  }

  // Contacts within e of a set are those of a ball that is larger by e and starts e further back.
  template <class Radius>
  GABARIT_HD double inflated(double s, Radius&& radius) const {
    const double e = s + spacing_ + tilt_ * least_;
    return radius(e * query_.direction, least_ + e) - e;
  }

  GABARIT_HD void visit_feature(const Primitive& p, const Vec3d& a, const Vec3d& b) {
    if ((!ahead(a) && !ahead(b)) || !can_be_touched_across(b - a)) return;
    const double s = static_cast<double>(p.sag) + sag_;
    const double ha = dot(query_.direction, a), hb = dot(query_.direction, b);
    const double shallow = ha < hb ? ha : hb, deep = ha < hb ? hb : ha;
    const double by_depth = 0.5 * (shallow - s);  // straight below the nearest place of the spacing
    if (by_depth >= least_) return;
    const double low = inflated(s, [&](const Vec3d& back, double) {
      return ball_through_segment(query_.direction, a + back, b + back).radius;
    });
    const double bound = by_depth > low ? by_depth : low;
    if (bound >= least_ || !can_leave(p.corner[2]) || !can_turn_away(p)) return;
    if (bound > 0 && deep / bound - 1 < -options_.cos_separation - 1e-6) return;
    record(by_depth, low);
  }

  // Inside an edge a ball touches across it: too steep an edge cannot turn its contact away far enough.
  GABARIT_HD bool can_be_touched_across(const Vec3d& edge) const {
    const double along = dot(edge, query_.direction), squared = squared_length(edge);
    if (!(squared > 0)) return true;
    const double rest = 1 - along * along / squared;
    return std::sqrt(rest > 0 ? rest : 0.0) >= -options_.cos_separation - tilt_ - 1e-6;
  }

  // Whether each direction of the fan leaves some ball that turns away far enough and lies straight below or
  // to any side: necessary for a contact, not enough.
  GABARIT_HD bool can_leave(std::uint32_t fan) const {
    const double cosine = -options_.cos_separation;
    const double sine = std::sqrt(cosine < 1 && cosine > -1 ? 1 - cosine * cosine : 0.0);
    for (std::uint32_t i = tree_.fan_first[fan]; i < tree_.fan_first[fan + 1]; ++i) {
      const Vec3f w = tree_.fan_directions[i];
      const double along = static_cast<double>(w.x) * query_.direction.x +
                           static_cast<double>(w.y) * query_.direction.y +
                           static_cast<double>(w.z) * query_.direction.z;
      const double across = std::sqrt(along < 1 && along > -1 ? 1 - along * along : 0.0);
      if (along < 0 && along * cosine + across * sine < -tilt_ - 1e-5) return false;
    }
    return true;
  }

  // Whether a contact on the feature can turn away far enough, for all that two directions in which the
  // surface leaves it say: the reflex edges of a finely bent wall do not face the wall that they belong to.
  GABARIT_HD bool can_turn_away(const Primitive& p) const {
    const bool edge = p.corner[0] != p.corner[1];
    const std::uint32_t end = tree_.fan_first[p.corner[2] + 1];
    for (std::uint32_t i = tree_.fan_first[p.corner[2]]; i < end; ++i) {
      for (std::uint32_t j = i + 1; j < end; ++j)
        if (!faces(to_double(tree_.fan_directions[i]), to_double(tree_.fan_directions[j]), edge))
          return false;
    }
    return true;
  }

  // Across the plane of the two directions contacts are free, but not on an edge.
  GABARIT_HD bool faces(const Vec3d& one, const Vec3d& other, bool edge) const {
    const Vec3d sum = one + other;
    const ContactArc arc(sum);
    if (!arc.bounds()) return true;
    const double middle = dot(sum, query_.direction) / (2 * arc.sine_of_half);
    const double aside = std::fabs(dot(normalized(one - other), query_.direction));
    const double plane = middle * middle + aside * aside;
    const bool within = middle > 0 && middle * middle >= plane * arc.cosine * arc.cosine;
    double farthest = within ? std::sqrt(plane) : middle * arc.cosine + aside * arc.sine;
    if (!edge) {
      const double across = plane < 1 ? 1 - plane : 0.0;
      farthest = std::sqrt((farthest > 0 ? farthest * farthest : 0.0) + across);
    }
    return farthest >= -options_.cos_separation - tilt_ - 1e-5;
  }

  GABARIT_HD static Vec3d to_double(const Vec3f& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
  }

  GABARIT_HD void record(double one, double other) {
    const double bound = one > other ? one : other;
    if (!(bound < least_)) return;
    least_ = bound > 0 ? bound : 0.0;
    shrink();
  }

  GABARIT_HD void shrink() {
    culling_.set_radius(least_);
    limit_ = least_ > 0 ? culling_.probe() / gap_.factor() : -1.0F;  // nothing is below zero
  }

  const BvhView& tree_;
  const SphereOptions& options_;
  const SphereQuery& query_;
  double sag_, spacing_, tilt_;
  double least_;
  SphereCulling<true> culling_;
  SearchGap gap_;
  const Primitive* contact_ = nullptr;
  float limit_ = 0;
  int visits_ = 0;
};

}  // namespace gabarit
