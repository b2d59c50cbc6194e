#include <cmath>
#include <numbers>
#include <stdexcept>

#include "examples/motorcycle/solids.h"

namespace gabarit::motorcycle {

namespace {

using Ring = std::vector<Vec3d>;

// A half section and its mirror image, around from the lowest point.
Ring ring(const Section& section) {
  Ring points;
  const std::size_t n = section.half.size();
  for (std::size_t i = 0; i < n; ++i) points.push_back({section.x, section.half[i].x, section.half[i].y});
  for (std::size_t i = n - 1; i-- > 1;) points.push_back({section.x, -section.half[i].x, section.half[i].y});
  return points;
}

Ring ellipse(const Dome& dome, std::size_t points) {
  Ring all;
  for (std::size_t i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    all.push_back({dome.x, dome.centre.x + dome.half_width * std::sin(angle),
                   dome.centre.y - dome.half_height * std::cos(angle)});
  }
  return all;
}

// The row beyond a dome's tip: the opposite side, so that every meridian runs on smoothly over the tip.
Ring opposite(const Ring& ring) {
  Ring other;
  for (std::size_t i = 0; i < ring.size(); ++i) other.push_back(ring[(i + ring.size() / 2) % ring.size()]);
  return other;
}

void weights(double f, double (&w)[4]) {
  const double g = 1 - f, f2 = f * f, f3 = f2 * f;
  w[0] = g * g * g / 6, w[1] = (3 * f3 - 6 * f2 + 4) / 6, w[2] = (-3 * f3 + 3 * f2 + 3 * f + 1) / 6,
  w[3] = f3 / 6;
}

Vec3d spline(const std::vector<Ring>& rows, double u, double v) {
  const std::size_t columns = rows[0].size();
  const auto i = static_cast<std::size_t>(std::min(std::floor(u), static_cast<double>(rows.size() - 4)));
  const auto k = static_cast<std::size_t>(std::min(std::floor(v), static_cast<double>(columns - 1)));
  double wu[4], wv[4];
  weights(u - static_cast<double>(i), wu), weights(v - static_cast<double>(k), wv);
  Vec3d p;
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = 0; b < 4; ++b) p += (wu[a] * wv[b]) * rows[i + a][(k + b) % columns];
  }
  return p;
}

}  // namespace

Surface lofted(const Dome& front, const std::vector<Section>& sections, const Dome& rear) {
  const std::size_t columns = 2 * sections.at(0).half.size() - 2;
  if (columns % 2 != 0 || columns < 6)
    throw std::invalid_argument("a loft needs at least four points a section");
  const Ring first = ellipse(front, columns), last = ellipse(rear, columns);
  const Vec3d first_tip{front.tip_x, front.centre.x, front.centre.y};
  const Vec3d last_tip{rear.tip_x, rear.centre.x, rear.centre.y};
  std::vector<Ring> rows{opposite(first), Ring(columns, first_tip), first};
  for (const Section& section : sections) rows.push_back(ring(section));
  rows.push_back(last), rows.push_back(Ring(columns, last_tip)), rows.push_back(opposite(last));
  for (const Ring& r : rows) {
    if (r.size() != columns) throw std::invalid_argument("the sections of a loft differ in their points");
  }

  Surface surface;
  for (std::size_t i = 0; i + 3 <= rows.size(); ++i) surface.u_breaks.push_back(static_cast<double>(i));
  for (std::size_t i = 0; i <= columns; ++i) surface.v_breaks.push_back(static_cast<double>(i));
  surface.at = [rows = std::move(rows)](double u, double v) { return spline(rows, u, v); };
  // Around from the lowest point to y > 0, rearward in u: du × dv = x × y at the bottom = z, inward.
  surface.flipped = true;
  surface.smooth_u = surface.smooth_v = true;
  return surface;
}

}  // namespace gabarit::motorcycle
