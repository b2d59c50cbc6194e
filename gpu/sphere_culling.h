// Lower bounds of the ball radius that anything below a node's children can leave; floats, rounded so that
// nothing is lost. Shared by the searches for the ball and for its lower bound.
#pragma once

#include "gpu/maximal_sphere.h"

namespace gabarit {

// Near-ties everywhere, as opposite every point of a finely meshed sphere, would visit the whole tree: after
// so many nodes a search settles for less and less; the lower bound says by how much.
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

class SphereCulling {
 public:
  GABARIT_HD SphereCulling(const BvhView& tree, const SphereOptions& options, const Vec3d& point,
                           const Vec3d& direction, const Looseness& looseness = {})
      : base_(point - tree.origin), exact_direction_(direction), loose_(looseness) {
    origin_ = to_float(base_);
    direction_ = to_float(direction);
    cosine_ = static_cast<float>(options.cos_separation);
    sine_ = std::sqrt(1 - cosine_ * cosine_);
    slop_ = 1e-6F * (3 * tree.reach + largest(origin_)) + loose_.inflation;
  }

  // Contacts that leave larger balls do not matter any more.
  GABARIT_HD void set_radius(double radius) {
    probe_ = static_cast<float>(radius) * (1 + 1e-6F);
    centre_ = to_float(base_ + static_cast<double>(probe_) * exact_direction_);
  }
  GABARIT_HD float probe() const { return probe_; }

  GABARIT_HD void lower_bounds(const BvhNode& node, float (&lower)[tree_width]) const {
    const Vec3f o = origin_, d = direction_, c = centre_;
    const float t = probe_, tt = t * t, slop = slop_, cosine = cosine_, sine = sine_;
    const float near = slop + loose_.spacing, nearer = near + t * loose_.tilt;
    for (int i = 0; i < tree_width; ++i) {
      const float a = square(node.lo[0][i] - o.x, o.x - node.hi[0][i], near) +
                      square(node.lo[1][i] - o.y, o.y - node.hi[1][i], near) +
                      square(node.lo[2][i] - o.z, o.z - node.hi[2][i], near);
      const float b = square(node.lo[0][i] - c.x, c.x - node.hi[0][i], nearer) +
                      square(node.lo[1][i] - c.y, c.y - node.hi[1][i], nearer) +
                      square(node.lo[2][i] - c.z, c.z - node.hi[2][i], nearer);
      // Every q in the box has |q|² >= a and |q - t d|² >= b, so its ball is no smaller than this.
      const float by_box = t * a / (a + (tt - b) + 2e-6F * tt) * (1 - 2e-6F);
      // Every q below has axis·q >= h: its ball is no smaller than the one that is tangent to that plane.
      const float along = node.axis[0][i] * d.x + node.axis[1][i] * d.y + node.axis[2][i] * d.z;
      const float rest = 1 - along * along;
      const float across = std::sqrt(rest > 0 ? rest : 0.0F);
      const float h = node.offset[i] -
                      (node.axis[0][i] * o.x + node.axis[1][i] * o.y + node.axis[2][i] * o.z) - slop -
                      loose_.spacing * across;
      const float by_plane =
          h / (1 + along + across * loose_.tilt + 0.5F * loose_.tilt * loose_.tilt + 4e-6F) * (1 - 2e-6F);
      // No normal below turns away far enough: along < cos(cone + pi - separation).
      const float narrow = node.cone[i];
      const float wide = std::sqrt(1 - narrow * narrow);
      const bool faces = (narrow <= cosine) | (along >= -narrow * cosine - wide * sine - 4e-6F);
      float bound = by_box > 0 ? by_box : 0.0F;
      bound = by_plane > bound ? by_plane : bound;
      lower[i] = faces & (b < tt) ? bound : std::numeric_limits<float>::infinity();
    }
  }

 private:
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
  float probe_ = 0, slop_ = 0, cosine_ = 0, sine_ = 0;
};

}  // namespace gabarit
