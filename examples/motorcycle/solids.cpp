#include "examples/motorcycle/solids.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gabarit::motorcycle {

namespace {

std::vector<double> whole_numbers(int from, int to) {
  std::vector<double> all;
  for (int i = from; i <= to; ++i) all.push_back(i);
  return all;
}

}  // namespace

Surface revolved(const Outline& profile, const Placement& place) {
  Surface surface;
  surface.at = [=](double u, double v) {
    const Vec2 p = profile.at(u);
    const double angle = v * std::numbers::pi / 2;
    return place({p.x * std::cos(angle), p.x * std::sin(angle), p.y});
  };
  surface.u_breaks = whole_numbers(0, profile.pieces());
  surface.v_breaks = whole_numbers(0, 4);
  surface.flipped = true;
  return surface;
}

Surface turned_ring(const Outline& profile, const Placement& place) {
  Surface surface = revolved(profile, place);
  surface.ring = true;
  return surface;
}

Surface prism(const Outline& outline, const Outline& profile, Vec2 centre, const Placement& place) {
  const int n = profile.pieces();
  Surface surface;
  surface.at = [=](double u, double v) {
    const double inside = u < 0 ? 0 : u > n ? n : u;  // beyond the profile the faces are filled
    const Vec2 p = profile.at(inside);
    const Vec2 edge = outline.at(v) - p.x * outline.normal(v);
    const double share = 1 - std::abs(u - inside);
    const Vec2 q = centre + share * (edge - centre);
    return place({q.x, q.y, p.y});
  };
  surface.u_breaks = whole_numbers(-1, n + 1);
  surface.v_breaks = whole_numbers(0, outline.pieces());
  surface.smooth_v = outline.is_spline();
  surface.flipped = true;
  return surface;
}

static Outline edge_profile(double thickness, double edge) {
  return Outline::open({{edge, 0}, {0, 0, edge}, {0, thickness, edge}, {edge, thickness}});
}

Surface plate(const Outline& outline, double thickness, double edge, Vec2 centre, const Placement& place) {
  const Outline sharp = Outline::open({{0, 0}, {0, thickness}});
  return prism(outline, edge > 0 ? edge_profile(thickness, edge) : sharp, centre, place);
}

Surface rounded_box(const Vec3d& size, double corner, double edge, const Placement& place) {
  const Placement middle = [=](const Vec3d& p) { return place({p.x, p.y, p.z - size.z / 2}); };
  return plate(Outline::rectangle(size.x, size.y, corner), size.z, edge, {}, middle);
}

// The place of a profile that lies at this length along the path; lengths never decrease along a profile.
static double place_at(const Outline& profile, double length) {
  double low = 0, high = profile.pieces();
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    (profile.at(middle).y < length ? low : high) = middle;
  }
  return (low + high) / 2;
}

// A solid whose profile gives lengths along a path: where the path begins or ends to bend, a line follows.
static Surface with_joints(Surface surface, const Outline& profile, const Path& path) {
  std::vector<double>& breaks = surface.u_breaks;
  for (const double joint : path.joints()) {
    const double place = place_at(profile, joint);
    const auto near = [&](double b) { return std::abs(b - place) < 1e-6; };
    if (std::none_of(breaks.begin(), breaks.end(), near)) breaks.push_back(place);
  }
  std::sort(breaks.begin(), breaks.end());
  return surface;
}

static Placement along(const Path& path) {
  return [path](const Vec3d& p) { return path.at(p); };
}

Surface turned_along(const Path& path, const Outline& profile) {
  return with_joints(revolved(profile, along(path)), profile, path);
}

Surface tube(const Path& path, double radius, TubeEnds ends) {
  const double end = path.length();
  return turned_along(path,
                      Outline::open({{0, 0}, {radius, 0, ends.first}, {radius, end, ends.last}, {0, end}}));
}

Surface swept(const Path& path, const Outline& section, double edge) {
  const double end = path.length();
  const Outline profile = edge > 0 ? edge_profile(end, edge) : Outline::open({{0, 0}, {0, end}});
  return with_joints(prism(section, profile, {}, along(path)), profile, path);
}

}  // namespace gabarit::motorcycle
