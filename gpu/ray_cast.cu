#include "gpu/answer_queries.h"
#include "gpu/ray_cast.h"
#include "gpu/traverse.h"

namespace gabarit {
namespace {

class FirstHit {
 public:
  using cheap_to_visit = void;

  GABARIT_HD FirstHit(const BvhView& tree, const Ray& ray) : tree_(tree), ray_(ray) {
    const Vec3d o = ray.point - tree.origin;
    Vec3f origin;
    for (int k = 0; k < 3; ++k) {
      origin[k] = static_cast<float>(o[k]);
      const auto d = static_cast<float>(ray.direction[k]);
      inverse_[k] = 1 / (d > 0 ? (d > 1e-20F ? d : 1e-20F) : (d < -1e-20F ? d : -1e-20F));
    }
    const Vec3f a = max(origin, -origin);
    const float slop = 1e-6F * (tree.reach + (a.x > a.y ? (a.x > a.z ? a.x : a.z) : (a.y > a.z ? a.y : a.z)));
    for (int k = 0; k < 3; ++k) low_from_[k] = origin[k] + slop, high_from_[k] = origin[k] - slop;
    from_ = static_cast<float>(ray.from) * (1 - 1e-6F);
  }

  // Finite from the start: a bound of infinity is never worth a look.
  GABARIT_HD float limit() const { return limit_; }

  template <class Boxes>
  GABARIT_HD void within(const Boxes& node, EightFloats& lower) const {
    const Vec3f from = low_from_, to = high_from_, inverse = inverse_;
    GABARIT_UNROLL
    for (int i = 0; i < tree_width; ++i) {
      float near = from_, far = limit_;
      for (int k = 0; k < 3; ++k) {
        const float u = (node.low(k, i) - from[k]) * inverse[k], v = (node.high(k, i) - to[k]) * inverse[k];
        const float enter = u < v ? u : v, leave = u < v ? v : u;
        near = enter > near ? enter : near;
        far = leave < far ? leave : far;
      }
      near *= 1 - 4e-6F;
      lower[i] = near <= far * (1 + 4e-6F) ? near : std::numeric_limits<float>::infinity();
    }
  }

  // Möller & Trumbore, Fast, Minimum Storage Ray-Triangle Intersection, 1997.
  GABARIT_HD void visit(const Primitive& p) {
    if (p.id == ray_.own || !p.is_facet()) return;
    const Vec3d a = tree_.corner(p, 0) - ray_.point;
    const Vec3d u = tree_.corner(p, 1) - ray_.point - a;
    const Vec3d v = tree_.corner(p, 2) - ray_.point - a;
    const Vec3d across = cross(ray_.direction, v);
    const double determinant = dot(u, across);
    if (!(determinant != 0)) return;
    // Shares of the facet times the size of the determinant: most facets are missed, without a division.
    const double size = std::fabs(determinant), sign = determinant < 0 ? -1.0 : 1.0;
    const double s = -sign * dot(a, across);
    if (!(s >= -1e-9 * size && s <= (1 + 1e-9) * size)) return;
    const Vec3d up = cross(-a, u);
    const double r = sign * dot(ray_.direction, up);
    if (!(r >= -1e-9 * size && s + r <= (1 + 1e-9) * size)) return;
    const double distance = dot(v, up) / determinant;
    if (!(distance > ray_.from)) return;
    if (distance > hit_.distance || (distance == hit_.distance && p.id > hit_.facet)) return;
    hit_ = {distance, p.id,
            static_cast<double>(p.normal.x) * ray_.direction.x +
                static_cast<double>(p.normal.y) * ray_.direction.y +
                static_cast<double>(p.normal.z) * ray_.direction.z,
            p.sag};
    limit_ = static_cast<float>(distance) * (1 + 1e-6F);
  }

  GABARIT_HD const RayHit& result() const { return hit_; }

 private:
  const BvhView& tree_;
  const Ray& ray_;
  RayHit hit_;
  Vec3f low_from_, high_from_, inverse_;
  float from_ = 0;
  float limit_ = 0.5F * std::numeric_limits<float>::max();  // an absent child is infinitely far
};

struct RayBatch {
  BvhView tree;
  View<const Ray> rays;
  View<RayHit> hits;

  template <VectorSet set>
  GABARIT_HD void run(std::int64_t i) const {
    FirstHit query(tree, rays[i]);
    traverse<set>(tree, query);
    hits[i] = query.result();
  }
};

}  // namespace

void cast_rays(const Bvh& tree, std::span<const Ray> rays, std::span<RayHit> hits) {
  answer_queries(tree, rays, hits, 1, 512, [&](View<const Ray> asked, View<RayHit> answers) {
    return RayBatch{tree.view(), asked, answers};
  });
}

}  // namespace gabarit
