#include "gpu/answer_queries.h"
#include "gpu/ray_cast.h"
#include "gpu/traverse.h"

namespace gabarit {
namespace {

class FirstHit {
 public:
  GABARIT_HD FirstHit(const BvhView& tree, const Ray& ray) : tree_(tree), ray_(ray) {
    const Vec3d o = ray.point - tree.origin;
    for (int k = 0; k < 3; ++k) {
      origin_[k] = static_cast<float>(o[k]);
      const auto d = static_cast<float>(ray.direction[k]);
      inverse_[k] = 1 / (d > 0 ? (d > 1e-20F ? d : 1e-20F) : (d < -1e-20F ? d : -1e-20F));
    }
    const Vec3f a = max(origin_, -origin_);
    slop_ = 1e-6F * (tree.reach + max(max(Vec3f{a.x, 0, 0}, Vec3f{a.y, 0, 0}), Vec3f{a.z, 0, 0}).x);
  }

  GABARIT_HD float limit() const { return static_cast<float>(hit_.distance) * (1 + 1e-6F); }

  GABARIT_HD void lower_bounds(const BvhNode& node, float (&lower)[tree_width]) const {
    for (int i = 0; i < tree_width; ++i) {
      float near = 0, far = std::numeric_limits<float>::infinity();
      for (int k = 0; k < 3; ++k) {
        const float u = (node.lo[k][i] - slop_ - origin_[k]) * inverse_[k];
        const float v = (node.hi[k][i] + slop_ - origin_[k]) * inverse_[k];
        const float first = u < v ? u : v, last = u < v ? v : u;
        near = first > near ? first : near;
        far = last < far ? last : far;
      }
      lower[i] = near * (1 - 4e-6F) <= far * (1 + 4e-6F) ? near * (1 - 4e-6F)
                                                         : std::numeric_limits<float>::infinity();
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
    const double s = -dot(a, across) / determinant;
    const Vec3d up = cross(-a, u);
    const double r = dot(ray_.direction, up) / determinant;
    if (!(s >= -1e-9 && r >= -1e-9 && s + r <= 1 + 1e-9)) return;
    const double distance = dot(v, up) / determinant;
    if (!(distance > ray_.from)) return;
    if (distance > hit_.distance || (distance == hit_.distance && p.id > hit_.facet)) return;
    hit_ = {distance, p.id,
            static_cast<double>(p.normal.x) * ray_.direction.x +
                static_cast<double>(p.normal.y) * ray_.direction.y +
                static_cast<double>(p.normal.z) * ray_.direction.z,
            p.sag};
  }

  GABARIT_HD const RayHit& result() const { return hit_; }

 private:
  const BvhView& tree_;
  const Ray& ray_;
  RayHit hit_;
  Vec3f origin_, inverse_;
  float slop_ = 0;
};

struct RayBatch {
  BvhView tree;
  View<const Ray> rays;
  View<RayHit> hits;

  GABARIT_HD void operator()(std::int64_t i) const {
    FirstHit query(tree, rays[i]);
    traverse(tree, query);
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
