#include "gpu/contact_cap.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "gpu/bvh_build.h"
#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

constexpr std::size_t most_directions = 64;  // of a fan that are worth comparing with each other
constexpr double tolerance = 2 * fan_tolerance;
constexpr double slack = 1e-3;         // radians: rounding, and contacts not quite across an edge
constexpr double least_cosine = 0.05;  // of a cap that is worth keeping

Vec3d to_double(const Vec3f& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

// Directions on the positive side of which all contacts lie, and the corners of what that leaves.
class CapOfFan {
 public:
  explicit CapOfFan(std::span<const Vec3f> directions) {
    if (directions.size() > most_directions) return;
    for (const Vec3f& w : directions) fan_.push_back(to_double(w));
    for (std::size_t i = 0; i < fan_.size(); ++i) bound_by(i, most_opposite(i));
  }

  // When all bounds lie nearly on one line, there are no corners.
  ContactCap of_vertex() {
    double widest = 0;
    for (std::size_t i = 0; i < bounds_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) widest = std::max(widest, meet(bounds_[i], bounds_[j]));
    return widest > 0.05 ? around() : ContactCap{};
  }

  // A bound that is not across the edge would not end the arc.
  ContactCap of_edge(const Vec3d& along) {
    for (const Vec3d& w : bounds_) {
      const Vec3d across = cross(along, w);
      if (!(length(across) > 0.99)) return {};
      keep(normalized(across));
      keep(-normalized(across));
    }
    return around();
  }

 private:
  std::size_t most_opposite(std::size_t i) const {
    std::size_t found = i;
    for (std::size_t j = 0; j < fan_.size(); ++j)
      if (dot(fan_[i], fan_[j]) < dot(fan_[i], fan_[found])) found = j;
    return found;
  }

  void bound_by(std::size_t i, std::size_t j) {
    const Vec3d sum = fan_[i] + fan_[j];
    const ContactArc arc(sum);
    if (!arc.bounds()) return;
    const Vec3d middle = normalized(sum), aside = normalized(fan_[i] - fan_[j]);
    bounds_.push_back(arc.sine * middle + arc.cosine * aside);
    bounds_.push_back(arc.sine * middle - arc.cosine * aside);
  }

  void keep(const Vec3d& outward) {
    for (const Vec3d& w : bounds_)
      if (dot(w, outward) < -1.5 * tolerance) return;
    corners_.push_back(outward);
  }

  // Keeps the two unit vectors that are by the tolerance on the wrong side of both. Returns the sine of the
  // angle between these.
  double meet(const Vec3d& v, const Vec3d& w) {
    const Vec3d across = cross(v, w);
    const double sine = length(across);
    if (!(sine > 1e-7)) return 0;
    const Vec3d middle = (-tolerance / (1 + dot(v, w))) * (v + w);
    const double rest = 1 - squared_length(middle);
    if (!(rest > 0)) return sine;
    const Vec3d aside = (std::sqrt(rest) / sine) * across;
    keep(middle + aside);
    keep(middle - aside);
    return sine;
  }

  // Corners in which several bounds meet count once.
  Vec3d middle_of_corners() const {
    Vec3d sum;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      bool known = false;
      for (std::size_t j = 0; j < i && !known; ++j) known = squared_length(corners_[i] - corners_[j]) < 1e-6;
      if (!known) sum += corners_[i];
    }
    return length(sum) > 0.1 ? normalized(sum) : Vec3d{};
  }

  // Of a cap narrower than a half-space the widest angle is at a corner.
  ContactCap around() const {
    const Vec3d mean = middle_of_corners();
    if (mean == Vec3d{}) return {};
    const Vec3f axis{static_cast<float>(mean.x), static_cast<float>(mean.y), static_cast<float>(mean.z)};
    double cosine = 1;
    for (const Vec3d& u : corners_) cosine = std::min(cosine, dot(u, to_double(axis)));
    cosine -= slack * std::sqrt(std::max(0.0, 1 - cosine * cosine)) + slack * slack;
    return cosine > least_cosine ? ContactCap{axis, round_down(cosine)} : ContactCap{};
  }

  std::vector<Vec3d> fan_, bounds_, corners_;
};

// How many edges and vertices name each fan.
std::vector<std::uint32_t> uses(const FacetSurface& surface) {
  std::vector<std::uint32_t> count(surface.fan_first.size() - 1);
  for (const Primitive& p : surface.primitives)
    if (!p.is_facet() && p.corner[2] < count.size()) ++count[p.corner[2]];
  return count;
}

}  // namespace

std::vector<ContactCap> contact_caps(const Device& device, const FacetSurface& surface) {
  if (surface.fan_directions.empty()) return {};
  std::vector<ContactCap> caps(surface.fan_first.size() - 1);
  const std::vector<std::uint32_t> named = uses(surface);
  const auto find = [&](std::int64_t i) {
    const Primitive& p = surface.primitives[static_cast<std::size_t>(i)];
    const std::size_t number = p.corner[2];
    if (p.is_facet() || number >= caps.size() || named[number] > 1) return;
    const std::size_t first = surface.fan_first[number], last = surface.fan_first[number + 1];
    CapOfFan fan(std::span(surface.fan_directions).subspan(first, last - first));
    const Vec3d along = surface.points[p.corner[1]] - surface.points[p.corner[0]];
    caps[number] = p.corner[0] == p.corner[1] ? fan.of_vertex() : fan.of_edge(normalized(along));
  };
  parallel_for_cpu(device, static_cast<std::int64_t>(surface.primitives.size()), find, 1024);
  return caps;
}

}  // namespace gabarit
