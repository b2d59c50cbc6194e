// The query behind maximal_spheres, for CPU and CUDA.
#pragma once

#include "gpu/maximal_sphere.h"
#include "gpu/tangent_ball.h"
#include "gpu/traverse.h"

namespace gabarit {

class MaximalSphere {
 public:
  GABARIT_HD MaximalSphere(const BvhView& tree, const SphereOptions& options, const SphereQuery& query)
      : tree_(tree), options_(options), query_(query) {
    const double c = options.cos_separation;
    slack_ = static_cast<double>(query.spacing) * std::sqrt((1 + c) / (1 - c + 1e-12)) +
             (static_cast<double>(query.sag) + options.greatest_sag) / (1 - c + 1e-12);
    origin_ = to_float(query.point - tree.origin);
    direction_ = to_float(query.direction);
    sin_separation_ = static_cast<float>(std::sqrt(1 - c * c));
    slop_ = 1e-6F * (3 * tree.reach + largest(origin_));
    shrink();
  }

  GABARIT_HD float limit() const { return limit_; }

  GABARIT_HD void lower_bounds(const BvhNode& node, float (&lower)[tree_width]) {
    if (++visits_ > patience) loosen();
    const Vec3f o = origin_, d = direction_, c = centre_;
    const float t = probe_, tt = t * t, slop = slop_;
    const auto cosine = static_cast<float>(options_.cos_separation);
    const float sine = sin_separation_;
    for (int i = 0; i < tree_width; ++i) {
      const float a = square(node.lo[0][i] - o.x, o.x - node.hi[0][i], slop) +
                      square(node.lo[1][i] - o.y, o.y - node.hi[1][i], slop) +
                      square(node.lo[2][i] - o.z, o.z - node.hi[2][i], slop);
      const float b = square(node.lo[0][i] - c.x, c.x - node.hi[0][i], slop) +
                      square(node.lo[1][i] - c.y, c.y - node.hi[1][i], slop) +
                      square(node.lo[2][i] - c.z, c.z - node.hi[2][i], slop);
      // Every q in the box has |q|² >= a and |q - t d|² >= b, so its ball is no smaller than this.
      const float by_box = t * a / (a + (tt - b) + 2e-6F * tt) * (1 - 2e-6F);
      // Every q below has axis·q >= h: its ball is no smaller than the one that is tangent to that plane.
      const float along = node.axis[0][i] * d.x + node.axis[1][i] * d.y + node.axis[2][i] * d.z;
      const float h =
          node.offset[i] - (node.axis[0][i] * o.x + node.axis[1][i] * o.y + node.axis[2][i] * o.z) - slop;
      const float by_plane = h / (1 + along + 4e-6F) * (1 - 2e-6F);
      // No normal below turns away far enough: along < cos(cone + pi - separation).
      const float narrow = node.cone[i];
      const float wide = std::sqrt(1 - narrow * narrow);
      const bool faces = narrow <= cosine || along >= -narrow * cosine - wide * sine - 4e-6F;
      float bound = by_box > 0 ? by_box : 0.0F;
      bound = h > 0 && by_plane > bound ? by_plane : bound;
      lower[i] = faces && b < tt ? bound : std::numeric_limits<float>::infinity();
    }
  }

  GABARIT_HD void visit(const Primitive& p) {
    if (p.id == query_.own) return;
    if (p.is_facet())
      visit_facet(p);
    else
      visit_feature(p);
  }

  // Contacts that were skipped have at least the radius up to which the search was complete.
  GABARIT_HD SphereContact result() const {
    SphereContact found = best_;
    const bool complete = gap_ == 0 && reach_ >= best_lower_ + slack_;
    const double skipped = complete ? best_lower_ : reach_ / (1 + static_cast<double>(gap_)) - slack_;
    const double low = best_lower_ < skipped ? best_lower_ : skipped;
    found.lower = low > 0 ? (low < options_.greatest_radius ? low : options_.greatest_radius) : 0.0;
    return found;
  }

  // Where in the tree the contact is; a good first guess for a neighbouring query.
  GABARIT_HD const Primitive* touched() const { return touched_; }

 private:
  // Near-ties everywhere, as opposite every point of a finely meshed sphere, would visit the whole tree:
  // after so many nodes the search settles for less and less; the lower bound says by how much.
  static constexpr int patience = 64;

  GABARIT_HD static float square(float below, float above, float slop) {
    float x = below > above ? below : above;
    x -= slop;
    x = x > 0 ? x : 0.0F;
    return x * x;
  }
  GABARIT_HD static Vec3f to_float(const Vec3d& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  }
  GABARIT_HD static float largest(const Vec3f& v) {
    const float x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
    return x > y ? (x > z ? x : z) : (y > z ? y : z);
  }

  GABARIT_HD void visit_facet(const Primitive& p) {
    const double facing = static_cast<double>(p.normal.x) * query_.direction.x +
                          static_cast<double>(p.normal.y) * query_.direction.y +
                          static_cast<double>(p.normal.z) * query_.direction.z;
    if (facing < -options_.cos_separation - 1e-6) return;
    record(p, ball_through_triangle(query_.direction, tree_.corner(p, 0) - query_.point,
                                    tree_.corner(p, 1) - query_.point, tree_.corner(p, 2) - query_.point,
                                    reach_));
  }

  // An edge or vertex is touched where the surface leaves it away from the ball in every direction of its
  // fan.
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
    if (leaves(p.corner[2], outward)) record(p, ball);
  }

  GABARIT_HD bool leaves(std::uint32_t fan, const Vec3d& outward) const {
    for (std::uint32_t i = tree_.fan_first[fan]; i < tree_.fan_first[fan + 1]; ++i) {
      const Vec3f w = tree_.fan_directions[i];
      if (static_cast<double>(w.x) * outward.x + static_cast<double>(w.y) * outward.y +
              static_cast<double>(w.z) * outward.z <
          -1e-5)
        return false;
    }
    return true;
  }

  GABARIT_HD void record(const Primitive& p, const TangentBall& ball) {
    const double t = ball.radius;
    if (!(t <= reach_)) return;
    const double qq = squared_length(ball.contact);
    if (!(qq > options_.contact_floor * options_.contact_floor)) return;
    const double h = dot(query_.direction, ball.contact);
    const double error = t * ((static_cast<double>(query_.sag) + static_cast<double>(p.sag)) / h);
    const double aside = std::sqrt(qq > h * h ? qq - h * h : 0.0) / h;
    const double low = t - error - static_cast<double>(query_.spacing) * aside;
    best_lower_ = low < best_lower_ ? low : best_lower_;
    if (t <= options_.greatest_radius) {
      if (t + error < best_.upper) best_.upper = t + error;
      if (t < best_.radius || (t == best_.radius && p.id < best_.primitive)) {
        best_.radius = t;
        best_.contact = query_.point + ball.contact;
        best_.primitive = p.id;
        touched_ = &p;
      }
    }
    shrink();
  }

  // How far contacts still matter: they may lie above the best one and yet have the lower bound.
  GABARIT_HD void shrink() {
    const double ceiling = best_.upper < options_.greatest_radius ? best_.upper : options_.greatest_radius;
    const double low = best_lower_ < options_.greatest_radius ? best_lower_ : options_.greatest_radius;
    const double wide = low + slack_ < 1.5 * ceiling ? low + slack_ : 1.5 * ceiling;
    const double reach = ceiling > wide ? ceiling : wide;
    if (!(reach < reach_)) return;
    reach_ = reach;
    probe_ = static_cast<float>(reach) * (1 + 1e-6F);
    centre_ = to_float(query_.point - tree_.origin + static_cast<double>(probe_) * query_.direction);
    limit_ = probe_ / (1 + gap_);
  }

  GABARIT_HD void loosen() {
    gap_ = gap_ > 0 ? gap_ * 1.04F : 1e-6F;
    if (gap_ > 0.03F) gap_ = 0.03F;
    limit_ = probe_ / (1 + gap_);
  }

  const BvhView& tree_;
  const SphereOptions& options_;
  const SphereQuery& query_;
  SphereContact best_;
  double best_lower_ = std::numeric_limits<double>::infinity();
  double reach_ = std::numeric_limits<double>::infinity();
  double slack_ = 0;
  const Primitive* touched_ = nullptr;
  Vec3f origin_, direction_, centre_;
  float probe_ = 0, limit_ = 0, gap_ = 0, slop_ = 0, sin_separation_ = 0;
  int visits_ = 0;
};

}  // namespace gabarit
