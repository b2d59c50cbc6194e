#include "tests/shrinking_sphere.h"

#include <algorithm>
#include <cmath>

#include "gpu/box.h"
#include "gpu/tangent_ball.h"
#include "gpu/triangle.h"

namespace gabarit {
namespace {

constexpr std::uint32_t leaf_size = 4;

double squared_distance(const Vec3d& p, const Vec3d& lo, const Vec3d& hi) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double outside = std::max({lo[k] - p[k], p[k] - hi[k], 0.0});
    sum += outside * outside;
  }
  return sum;
}

bool ray_meets(const Vec3d& o, const Vec3d& d, const Vec3d& lo, const Vec3d& hi) {
  double near = 0, far = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    if (d[k] == 0) {
      if (o[k] < lo[k] || o[k] > hi[k]) return false;
      continue;
    }
    const double u = (lo[k] - o[k]) / d[k], v = (hi[k] - o[k]) / d[k];
    near = std::max(near, std::min(u, v));
    far = std::min(far, std::max(u, v));
  }
  return near <= far;
}

// Infinite when the ray misses the triangle.
double ray_distance(const Vec3d& o, const Vec3d& d, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d u = b - a, v = c - a, across = cross(d, v);
  const double determinant = dot(u, across);
  if (determinant == 0) return std::numeric_limits<double>::infinity();
  const double s = dot(o - a, across) / determinant;
  const Vec3d up = cross(o - a, u);
  const double r = dot(d, up) / determinant, t = dot(v, up) / determinant;
  return s >= 0 && r >= 0 && s + r <= 1 && t > 0 ? t : std::numeric_limits<double>::infinity();
}

}  // namespace

ShrinkingSphere::ShrinkingSphere(const std::vector<Vec3d>& points, const std::vector<Primitive>& facets,
                                 double cos_separation)
    : cos_separation_(cos_separation) {
  for (const Primitive& p : facets) {
    const Vec3d a = points[p.corner[0]], b = points[p.corner[1]], c = points[p.corner[2]];
    if (p.is_facet()) facets_.push_back({a, b, c, normalized(cross(b - a, c - a)), p.id});
  }
  nodes_.reserve(facets_.size());
  build(0, static_cast<std::uint32_t>(facets_.size()));
  const Vec3d e = nodes_.front().max - nodes_.front().min;
  size_ = length(e);
  smallest_side_ = std::min({e.x, e.y, e.z});
}

std::uint32_t ShrinkingSphere::build(std::uint32_t begin, std::uint32_t end) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Box3d box;
  for (std::uint32_t i = begin; i < end; ++i)
    box.add(facets_[i].a), box.add(facets_[i].b), box.add(facets_[i].c);
  nodes_[number] = {box.min, box.max, begin, end - begin};
  if (end - begin <= leaf_size) return number;
  const Vec3d e = box.extent();
  const int axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(facets_.begin() + begin, facets_.begin() + middle, facets_.begin() + end,
                   [axis](const Facet& x, const Facet& y) {
                     return x.a[axis] + x.b[axis] + x.c[axis] < y.a[axis] + y.b[axis] + y.c[axis];
                   });
  build(begin, middle);
  const std::uint32_t second = build(middle, end);
  nodes_[number].first = second;
  nodes_[number].count = 0;
  return number;
}

bool ShrinkingSphere::counts(const Facet& facet, const Vec3d& direction, std::uint32_t own) const {
  return facet.id != own && dot(facet.normal, direction) >= -cos_separation_ - 1e-6;
}

double ShrinkingSphere::first_radius(const Vec3d& point, const Vec3d& direction, std::uint32_t own) const {
  double nearest = std::numeric_limits<double>::infinity();
  std::uint32_t stack[64];
  int top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const std::uint32_t number = stack[--top];
    const Node& node = nodes_[number];
    if (!ray_meets(point, direction, node.min, node.max)) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Facet& f = facets_[i];
      if (counts(f, direction, own))
        nearest = std::min(nearest, ray_distance(point, direction, f.a, f.b, f.c));
    }
    if (node.count == 0) stack[top++] = node.first, stack[top++] = number + 1;
  }
  return std::isfinite(nearest) ? nearest / 2 : smallest_side_ / 2;
}

template <class Visit>
void ShrinkingSphere::within(const Vec3d& centre, double radius, Visit&& visit) const {
  std::uint32_t stack[64];
  int top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const std::uint32_t number = stack[--top];
    const Node& node = nodes_[number];
    if (squared_distance(centre, node.min, node.max) > radius * radius) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) visit(facets_[i]);
    if (node.count == 0) stack[top++] = node.first, stack[top++] = number + 1;
  }
}

ShrunkSphere ShrinkingSphere::shrink(const Vec3d& point, const Vec3d& direction, std::uint32_t own) const {
  ShrunkSphere ball{first_radius(point, direction, own), 0};
  for (double change = size_; 2 * change >= 1e-6 * size_ && ball.iterations < 1000; ++ball.iterations) {
    const double radius = ball.radius;
    const Vec3d centre = point + radius * direction;
    within(centre, radius, [&](const Facet& f) {
      if (!counts(f, direction, own)) return;
      const Vec3d p = closest_point(centre, f.a, f.b, f.c);
      if (squared_length(p - centre) >= radius * radius) return;
      ball.radius = std::min(ball.radius, ball_through_point(direction, p - point).radius);
    });
    change = radius - ball.radius;
  }
  return ball;
}

ShrunkSphere ShrinkingSphere::bisect(const Vec3d& point, const Vec3d& direction, std::uint32_t own) const {
  double low = 0, high = std::numeric_limits<double>::infinity();
  ShrunkSphere ball{first_radius(point, direction, own), 0};
  for (double change = size_; 2 * change >= 1e-6 * size_ && ball.iterations < 1000; ++ball.iterations) {
    const Vec3d centre = point + ball.radius * direction;
    bool pierced = false;
    within(centre, ball.radius, [&](const Facet& f) {
      if (pierced || !counts(f, direction, own)) return;
      const Vec3d p = closest_point(centre, f.a, f.b, f.c);
      pierced = length(p - centre) < ball.radius * (1 - 1e-12);
    });
    (pierced ? high : low) = ball.radius;
    const double next = !std::isfinite(high) ? 1.5 * ball.radius : low > 0 ? (low + high) / 2 : high / 2;
    change = std::fabs(next - ball.radius);
    ball.radius = next;
    if (!std::isfinite(high) && ball.radius > size_) break;
  }
  return ball;
}

}  // namespace gabarit
