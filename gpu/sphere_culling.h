// Lower bounds of the ball radius that anything below a node's children can leave; floats, rounded so that
// nothing is lost. Shared by the searches for the ball and for its lower bound.
#pragma once

#include "gpu/maximal_sphere.h"
#include "gpu/no_greater.h"

namespace gabarit {

// Near-ties everywhere, as opposite every point of a finely meshed sphere, would visit the whole tree: after
// so many nodes and leaves a search settles for less and less; the lower bound says by how much.
class SearchGap {
 public:
  GABARIT_HD float factor() const { return 1 + gap_; }
  GABARIT_HD float widen() {
    gap_ = gap_ > 0 ? gap_ * 1.04F : 1e-6F;
    if (gap_ > greatest) gap_ = greatest;
    return factor();
  }

 private:
  static constexpr float greatest = 0.01F;
  float gap_ = 0;
};

// How much looser than for the exact query: contacts may come nearer by `inflation` in any direction and, as
// the point moves in its plane, by `spacing` across the direction, which may turn by `tilt`.
struct Looseness {
  float inflation = 0, spacing = 0, tilt = 0;
};

// Exact queries leave out all that looseness costs.
template <bool loose>
class SphereCulling {
 public:
  GABARIT_HD SphereCulling(const BvhView& tree, const SphereOptions& options, const Vec3d& point,
                           const Vec3d& direction, const Looseness& looseness = {})
      : base_(point - tree.origin), exact_direction_(direction), loose_(looseness) {
    origin_ = to_float(base_);
    direction_ = to_float(direction);
    cosine_ = static_cast<float>(options.cos_separation);
    if constexpr (loose) {  // a direction that tilts meets contacts that turn away by less
      cosine_ += looseness.tilt + 2e-5F;
      if (cosine_ > 1) cosine_ = 1;
    }
    squared_sine_ = 1 - cosine_ * cosine_;
    for (int k = 0; k < 3; ++k) {
      const float across = 1 - direction_[k] * direction_[k];
      across_[k] = std::sqrt((across > 0 ? across : 0.0F) + 4e-7F);
    }
    slop_ = 1e-6F * (3 * tree.reach + largest(origin_)) + loose_.inflation;
  }

  // Contacts that leave larger balls do not matter any more.
  GABARIT_HD void set_radius(double radius) {
    probe_ = static_cast<float>(radius) * (1 + 1e-6F);
    centre_ = to_float(base_ + static_cast<double>(probe_) * exact_direction_);
  }
  GABARIT_HD float probe() const { return probe_; }

  // Infinity: no ball of the radius reaches it.
  GABARIT_HD void within(const BvhLeaf& boxes, EightFloats& lower) const {
    const Ball ball(*this);
    GABARIT_UNROLL
    for (int i = 0; i < leaf_width; ++i) lower[i] = ball.bound(boxes, i);
  }

  GABARIT_HD void within(const BvhNode& node, EightFloats& lower) const {
    const Ball ball(*this);
    const Vec3f o = origin_, d = direction_;
    const float slop = slop_, cosine = cosine_, squared_sine = squared_sine_;
    const float spacing = loose_.spacing, tilt = loose_.tilt;
    GABARIT_UNROLL
    for (int i = 0; i < tree_width; ++i) {
      const float by_box = ball.bound(node, i);
      // Every q below has axis·q >= h: its ball is no smaller than the one that is tangent to that plane.
      const float along = node.axis[0][i] * d.x + node.axis[1][i] * d.y + node.axis[2][i] * d.z;
      float h =
          node.offset[i] - (node.axis[0][i] * o.x + node.axis[1][i] * o.y + node.axis[2][i] * o.z) - slop;
      float spread = 1 + along + 4e-6F;
      if constexpr (loose) {
        const float rest = 1 - along * along;
        const float across = std::sqrt(rest > 0 ? rest : 0.0F);
        h -= spacing * across;
        spread += across * tilt + 0.5F * tilt * tilt;
      }
      const float by_plane = h / spread * (1 - 2e-6F);
      // No normal below turns away far enough: along < cos(cone + pi - separation), without a square root.
      const float narrow = node.cone[i];
      const float beyond = along + narrow * cosine + 4e-6F;
      const bool faces =
          (narrow <= cosine) | (beyond >= 0) | (beyond * beyond <= (1 - narrow * narrow) * squared_sine);
      const float bound = by_plane > by_box ? by_plane : by_box;
      lower[i] = faces ? bound : std::numeric_limits<float>::infinity();
    }
  }

 private:
  // What stays the same for all boxes, in variables of its own: they are registers.
  struct Ball {
    Vec3f o, c, near, nearer;
    float t, tt;
    GABARIT_HD explicit Ball(const SphereCulling& s)
        : o(s.origin_),
          c(s.centre_),
          near{s.slop_, s.slop_, s.slop_},
          nearer(near),
          t(s.probe_),
          tt(s.probe_ * s.probe_) {
      if constexpr (loose) {  // a disk across the direction reaches less far along some axes than others
        const float turn = s.probe_ * s.loose_.tilt, sag = 0.5F * turn * s.loose_.tilt;
        near += s.loose_.spacing * s.across_;
        nearer = near + Vec3f{sag, sag, sag} + turn * s.across_;
      }
    }

    // Every q in the box has |q|² >= a and |q - t d|² >= b.
    template <class Boxes>
    GABARIT_HD float bound(const Boxes& boxes, int i) const {
      const float a = square(boxes.low(0, i) - o.x, o.x - boxes.high(0, i), near.x) +
                      square(boxes.low(1, i) - o.y, o.y - boxes.high(1, i), near.y) +
                      square(boxes.low(2, i) - o.z, o.z - boxes.high(2, i), near.z);
      const float b = square(boxes.low(0, i) - c.x, c.x - boxes.high(0, i), nearer.x) +
                      square(boxes.low(1, i) - c.y, c.y - boxes.high(1, i), nearer.y) +
                      square(boxes.low(2, i) - c.z, c.z - boxes.high(2, i), nearer.z);
      const float by_box = t * a / (a + (tt - b) + 2e-6F * tt) * (1 - 2e-6F);
      return b < tt ? (by_box > 0 ? by_box : 0.0F) : std::numeric_limits<float>::infinity();
    }
  };
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

  Vec3d base_, exact_direction_;
  Looseness loose_;
  Vec3f origin_, direction_, centre_;
  Vec3f across_;  // how far a disk of radius 1 across the direction reaches along each axis
  float probe_ = 0, slop_ = 0, cosine_ = 0, squared_sine_ = 0;
};

}  // namespace gabarit
