#include "gpu/answer_queries.h"
#include "gpu/closest_point.h"
#include "gpu/traverse.h"
#include "gpu/triangle.h"

namespace gabarit {
namespace {

class Nearest {
 public:
  GABARIT_HD Nearest(const BvhView& tree, const Vec3d& point) : tree_(tree), point_(point) {
    const Vec3d o = point - tree.origin;
    origin_ = {static_cast<float>(o.x), static_cast<float>(o.y), static_cast<float>(o.z)};
    slop_ = 2e-6F * (tree.reach + std::fabs(origin_.x) + std::fabs(origin_.y) + std::fabs(origin_.z));
  }

  GABARIT_HD float limit() const { return limit_; }

  template <class Boxes>
  GABARIT_HD void within(const Boxes& node, EightFloats& lower) const {
    GABARIT_UNROLL
    for (int i = 0; i < tree_width; ++i) {
      float sum = 0;
      for (int k = 0; k < 3; ++k) {
        const float below = node.low(k, i) - origin_[k], above = origin_[k] - node.high(k, i);
        const float outside = (below > above ? below : above) - slop_;
        sum += outside > 0 ? outside * outside : 0.0F;
      }
      lower[i] = sum * (1 - 2e-6F);
    }
  }

  GABARIT_HD void visit(const Primitive& p) {
    if (!p.is_facet()) return;
    const Vec3d q = closest_point({}, tree_.corner(p, 0) - point_, tree_.corner(p, 1) - point_,
                                  tree_.corner(p, 2) - point_);
    const double squared = squared_length(q);
    if (squared > squared_ || (squared == squared_ && p.id > closest_.facet)) return;
    squared_ = squared;
    limit_ = static_cast<float>(squared) * (1 + 1e-6F);
    closest_ = {std::sqrt(squared), point_ + q, p.id};
  }

  GABARIT_HD const ClosestPoint& result() const { return closest_; }

 private:
  const BvhView& tree_;
  const Vec3d& point_;
  ClosestPoint closest_;
  double squared_ = std::numeric_limits<double>::infinity();
  Vec3f origin_;
  float limit_ = std::numeric_limits<float>::max();  // an absent child is infinitely far
  float slop_ = 0;
};

struct ClosestBatch {
  BvhView tree;
  View<const Vec3d> points;
  View<ClosestPoint> closest;

  template <VectorSet set>
  GABARIT_HD void run(std::int64_t i) const {
    Nearest query(tree, points[i]);
    traverse<set>(tree, query);
    closest[i] = query.result();
  }
};

}  // namespace

void closest_points(const Bvh& tree, std::span<const Vec3d> points, std::span<ClosestPoint> closest) {
  answer_queries(tree, points, closest, 1, 512, [&](View<const Vec3d> asked, View<ClosestPoint> answers) {
    return ClosestBatch{tree.view(), asked, answers};
  });
}

}  // namespace gabarit
