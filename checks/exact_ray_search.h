// One exact ray: the faces whose facets lie near it, nearest first.
#pragma once

#include "checks/exact_ray.h"
#include "gpu/traverse.h"
#include "model/brep_ray.h"

namespace gabarit {

class ExactRaySearch {
 public:
  GABARIT_HD ExactRaySearch(const ExactRayView& view, const ExactRayOptions& options,
                            const ExactRayQuery& query)
      : view_(view),
        options_(options),
        frame_(query.point, query.direction),
        own_(query.face),
        sure_(options.greatest) {
    close_ = 1e-10 * (static_cast<double>(view.tree.reach) + length(query.point));
    const Vec3d o = query.point - view.tree.origin;
    const float a = static_cast<float>(std::max({std::fabs(o.x), std::fabs(o.y), std::fabs(o.z)}));
    const float wider = static_cast<float>(options.slack) * (1 + 1e-6F) + 1e-6F * (view.tree.reach + a);
    for (int k = 0; k < 3; ++k) {
      const auto d = static_cast<float>(query.direction[k]);
      inverse_[k] = 1 / (d > 0 ? (d > 1e-20F ? d : 1e-20F) : (d < -1e-20F ? d : -1e-20F));
      const float back = inverse_[k] > 0 ? wider : -wider;
      const auto origin = static_cast<float>(o[k]);
      enter_from_[k] = origin + back, leave_from_[k] = origin - back;
    }
    update_limit();
  }

  GABARIT_HD float limit() const { return limit_; }

  template <class Boxes>
  GABARIT_HD void within(const Boxes& node, EightFloats& lower) const {
    for (int i = 0; i < tree_width; ++i) {
      float near = 0, far = limit_;
      for (int k = 0; k < 3; ++k) {
        const bool up = inverse_[k] > 0;
        const float u = ((up ? node.low(k, i) : node.high(k, i)) - enter_from_[k]) * inverse_[k];
        const float v = ((up ? node.high(k, i) : node.low(k, i)) - leave_from_[k]) * inverse_[k];
        near = u > near ? u : near;
        far = v < far ? v : far;
      }
      near *= 1 - 4e-6F;
      lower[i] = near <= far * (1 + 4e-6F) ? near : std::numeric_limits<float>::infinity();
    }
  }

  GABARIT_HD void visit(const Primitive& p) {
    if (!p.is_facet()) return;
    Vec3d corner[3];
    for (int i = 0; i < 3; ++i) corner[i] = frame_.seen(view_.tree.corner(p, i));
    const Near near = nearest(corner);
    if (near.beside > options_.slack) return;
    if (near.along - options_.slack > sure_ || !meet(p, near)) doubt(p, near);
  }

  GABARIT_HD ExactRay result() const {
    ExactRay ray;
    // A hit that tolerance alone decides is real when the next sure one cannot be the end as well.
    const bool either = first_.distance < sure_ && hit_.face != no_number && hit_.right == first_.right;
    const Hit& end = first_.distance < hit_.distance && !(either && !first_.inside) ? first_ : hit_;
    if (end.face == no_number) return ray;
    ray.distance = end.distance, ray.end = end.end, ray.face = end.face, ray.right = end.right;
    if (either) ray.open = hit_.distance - first_.distance;
    ray.verified = std::min(end.distance, first_.distance) <= doubt_;
    return ray;
  }

 private:
  static constexpr double least_crossing_ = 1e-6;  // radians between ray and face

  struct Hit {
    double distance = std::numeric_limits<double>::infinity();
    Vec3d end;
    FaceId face = no_number;
    bool right = false, inside = false;
  };
  // The place of a facet nearest to the line, as shares of its corners; `crossed`: the line goes through it.
  struct Near {
    double beside = 0, along = 0, share[3] = {0, 0, 0};
    bool crossed = false;
  };

  GABARIT_HD void update_limit() {
    const double far = sure_ + 2 * options_.slack;
    limit_ = far < 1e30 ? static_cast<float>(far) * (1 + 1e-6F) : 1e30F;
  }

  // In the plane across the line, where the line is the origin.
  GABARIT_HD static Near nearest(const Vec3d (&c)[3]) {
    const auto turn = [](const Vec3d& a, const Vec3d& b) { return a.x * b.y - a.y * b.x; };
    const double w[3] = {turn(c[1], c[2]), turn(c[2], c[0]), turn(c[0], c[1])};
    const double area = w[0] + w[1] + w[2];
    Near near;
    near.crossed = (w[0] >= 0 && w[1] >= 0 && w[2] >= 0 && area > 0) ||
                   (w[0] <= 0 && w[1] <= 0 && w[2] <= 0 && area < 0);
    if (near.crossed) {
      for (int i = 0; i < 3; ++i) near.share[i] = w[i] / area;
    } else {
      near.beside = std::numeric_limits<double>::infinity();
      for (int i = 0; i < 3; ++i) nearest_on_side(c, i, near);
    }
    for (int i = 0; i < 3; ++i) near.along += near.share[i] * c[i].z;
    return near;
  }
  GABARIT_HD static void nearest_on_side(const Vec3d (&c)[3], int i, Near& near) {
    const int j = (i + 1) % 3;
    const double x = c[j].x - c[i].x, y = c[j].y - c[i].y, size = x * x + y * y;
    const double part = size > 0 ? std::clamp(-(c[i].x * x + c[i].y * y) / size, 0.0, 1.0) : 0.0;
    const double beside = aside({c[i].x + part * x, c[i].y + part * y, 0});
    if (!(beside < near.beside)) return;
    near.beside = beside;
    near.share[0] = near.share[1] = near.share[2] = 0;
    near.share[i] = 1 - part, near.share[j] = part;
  }

  // Whether the face behind the facet explains that the ray comes by.
  GABARIT_HD bool meet(const Primitive& p, const Near& near) {
    const FacetOrigin& origin = view_.facets[p.id];
    const Face& face = view_.brep.faces[origin.face];
    const RayMeeting meeting = meet_surface(
        view_.brep, face, frame_, parameters_at(origin, near.share[0], near.share[1], near.share[2]), close_);
    if (!meeting.met) return false;
    // From the rim of a wall the ray runs along the face that ends there: that is no end.
    const Vec3d across = cross(meeting.du, meeting.dv);
    if (std::fabs(dot(across, frame_.direction)) <= least_crossing_ * length(across)) return true;
    const Presence present = presence(view_.brep, origin.face, meeting, view_.face_reach[origin.face]);
    if (present == Presence::absent) return false;
    if (meeting.distance > options_.floor && !starts_on(origin.face, meeting.distance))
      add(meeting, origin.face, present);
    return true;
  }

  // At an edge the next face may be met as far ahead as the edge's tolerance leaves open, at many times that
  // where the faces nearly make a right angle.
  GABARIT_HD bool starts_on(FaceId id, double distance) const {
    constexpr double aslant = 64;  // tolerances
    if (id == own_ || distance > aslant * view_.face_reach[own_]) return false;
    for (std::uint32_t i = view_.brep.first_edge_of_face[own_]; i < view_.brep.first_edge_of_face[own_ + 1];
         ++i) {
      const Edge& edge = view_.brep.edges[view_.brep.edges_of_face[i]];
      if (edge.faces[0] != id && edge.faces[1] != id) continue;
      if (distance <= 2 * edge.tolerance) return true;
      if (distance <= 2 * aslant * edge.tolerance &&
          distance_to_edge(view_.brep, edge, frame_.point) <= 2 * edge.tolerance)
        return true;
    }
    return false;
  }

  GABARIT_HD void add(const RayMeeting& meeting, FaceId id, Presence present) {
    if (!(meeting.distance <= options_.greatest)) return;
    const Vec3d out = cross(meeting.du, meeting.dv) * (options_.sign * view_.brep.faces[id].sign);
    const bool inside =
        present == Presence::there || trim_side(view_.brep, id, meeting.at) == TrimSide::inside;
    const Hit hit{meeting.distance, meeting.p, id, dot(out, frame_.direction) > 0, inside};
    keep_nearer(first_, hit);
    if (present != Presence::there) return;
    keep_nearer(hit_, hit);
    sure_ = hit_.distance;
    update_limit();
  }
  // Equal distances: the face with the smaller number, whatever the order.
  GABARIT_HD static void keep_nearer(Hit& kept, const Hit& hit) {
    if (hit.distance < kept.distance || (hit.distance == kept.distance && hit.face < kept.face)) kept = hit;
  }

  // The ray crosses a facet, and no face was met there.
  GABARIT_HD void doubt(const Primitive& p, const Near& near) {
    if (!near.crossed || near.along <= options_.floor) return;
    const double facing = std::fabs(static_cast<double>(p.normal.x) * frame_.direction.x +
                                    static_cast<double>(p.normal.y) * frame_.direction.y +
                                    static_cast<double>(p.normal.z) * frame_.direction.z);
    doubt_ = std::min(doubt_, near.along + 2 * options_.slack / std::max(facing, 0.05));
  }

  const ExactRayView& view_;
  const ExactRayOptions& options_;
  RayFrame frame_;
  FaceId own_;
  double close_ = 0;
  double sure_;  // no hit beyond is looked for
  double doubt_ = std::numeric_limits<double>::infinity();
  Hit first_, hit_;  // the first that may be, and the first that is whatever the tolerance
  Vec3f enter_from_, leave_from_, inverse_;
  float limit_ = 0;
};

}  // namespace gabarit
