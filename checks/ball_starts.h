// Where to start looking for what stops a ball: the facet, or the chord of an edge, that is first met by the
// ball as it grows and was not tried yet.
#pragma once

#include "gpu/sphere_culling.h"
#include "gpu/tangent_ball.h"
#include "gpu/traverse.h"

namespace gabarit {

// Primitives and groups (faces, edges) that were tried.
class TriedStarts {
 public:
  static constexpr int most = 64;

  GABARIT_HD bool full() const { return count_ == most; }
  GABARIT_HD void add(std::uint32_t primitive, std::uint32_t group) {
    primitives_[count_] = primitive, groups_[count_] = group, ++count_;
  }
  GABARIT_HD bool has(std::uint32_t primitive) const { return holds(primitives_, primitive); }
  GABARIT_HD bool has_group(std::uint32_t group) const { return holds(groups_, group); }

 private:
  GABARIT_HD bool holds(const std::uint32_t* list, std::uint32_t x) const {
    for (int i = 0; i < count_; ++i)
      if (list[i] == x) return true;
    return false;
  }

  std::uint32_t primitives_[most], groups_[most];
  int count_ = 0;
};

struct BallStart {
  std::uint32_t primitive = no_child;  // place in the tree; none: nothing is left
  double radius = std::numeric_limits<double>::infinity();
  Vec3d contact;  // relative to the point
};

// A query of traverse(). A primitive whose group is new counts when it comes within its sag of the ball; one
// whose group was tried, when it reaches into the ball by more than its sag allows for.
template <class Group>
class BallStartSearch {
 public:
  GABARIT_HD BallStartSearch(const BvhView& tree, const SphereOptions& options, const Vec3d& point,
                             const Vec3d& direction, double bound, std::uint32_t own,
                             const TriedStarts& tried, const Group& group)
      : tree_(tree),
        point_(point),
        direction_(direction),
        bound_(bound),
        own_(own),
        tried_(tried),
        group_(group),
        culling_(tree, options, point, direction, {.inflation = tree.greatest_sag * 1.01F}) {
    culling_.set_radius(bound);
  }

  GABARIT_HD float limit() const {
    constexpr float most = std::numeric_limits<float>::max();
    return culling_.probe() < most ? culling_.probe() : most;
  }
  template <class Boxes>
  GABARIT_HD void within(const Boxes& boxes, EightFloats& lower) const {
    culling_.within(boxes, lower);
  }
  GABARIT_HD void visit(const Primitive& p) {
    if (p.is_facet() != Group::of_facets || p.id == own_ || tried_.has(p.id)) return;
    const TangentBall ball = ball_of(p);
    if (!(ball.radius < start.radius)) return;
    const double length_of_q = length(ball.contact), h = dot(direction_, ball.contact);
    const double sag = static_cast<double>(p.sag) + 1e-9 * length_of_q;
    const double near = length_of_q > sag ? length_of_q - sag : 0;
    const double least = near * near / (2 * (h + sag));
    if (!(least < bound_)) return;
    if (tried_.has_group(group_(p.id))) {
      const double deep = 1.5 * sag, far = length_of_q + deep;
      if (!(h > deep && far * far / (2 * (h - deep)) < bound_)) return;
    }
    start = {static_cast<std::uint32_t>(&p - tree_.primitives.data), ball.radius, ball.contact};
    if (ball.radius < bound_) culling_.set_radius(ball.radius);
  }

  BallStart start;

 private:
  GABARIT_HD TangentBall ball_of(const Primitive& p) const {
    const Vec3d a = tree_.corner(p, 0) - point_, b = tree_.corner(p, 1) - point_;
    if constexpr (Group::of_facets) {
      if (!group_.counts(p, direction_, tried_)) return {};
      return ball_through_triangle(direction_, a, b, tree_.corner(p, 2) - point_,
                                   std::numeric_limits<double>::infinity());
    } else {
      const TangentBall ball = ball_through_segment(direction_, a, b);
      return group_.counts(p, direction_, ball) ? ball : TangentBall{};
    }
  }

  const BvhView& tree_;
  Vec3d point_, direction_;
  double bound_;
  std::uint32_t own_;
  const TriedStarts& tried_;
  const Group& group_;
  SphereCulling<true> culling_;
};

}  // namespace gabarit
