#include "report/render/raster.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "report/render.h"
#include "report/render/clip.h"

namespace gabarit {

float head_start(std::uint8_t mark, float depth) {
  // Snapping moves a surface by up to its slope times 1/512 of a sample; the second part is float's rounding.
  return static_cast<float>(mark) * (1.0F / 16 + std::abs(depth) * 1e-6F);
}

static std::uint8_t mark_of(const Drawing& drawing, FacetId f) {
  return drawing.marked.empty() ? std::uint8_t{0} : drawing.marked[f];
}

bool comes_first(const Facets& facets, FacetId a, FacetId b) {
  const Drawing& drawing = *facets.drawing;
  const auto key = [&](FacetId f) {
    const Vec3f n = facets.screen->page_direction(facet_normal(*drawing.mesh, f));
    const Rgb c = drawing.facet_colours.empty() ? drawing.plain : drawing.facet_colours[f];
    return std::tuple(-int{mark_of(drawing, f)}, n.z < 0, -n.z, n.x, n.y, c.r, c.g, c.b, f);
  };
  return key(a) < key(b);
}

namespace {

struct Triangle {
  std::array<ScreenPoint, 3> corner;
  float nearer = 0;
};

// Signed distances of a sample from the three sides times their lengths, in units²; exact.
struct Sides {
  std::int64_t step_x[3], step_y[3], value[3];
};

Sides sides_at(const std::array<ScreenPoint, 3>& p, std::int64_t x, std::int64_t y) {
  Sides sides{};
  for (std::size_t i = 0; i < 3; ++i) {
    const ScreenPoint& from = p[(i + 1) % 3];
    const ScreenPoint& to = p[(i + 2) % 3];
    const std::int64_t dx = std::int64_t{to.x} - from.x;
    const std::int64_t dy = std::int64_t{to.y} - from.y;
    sides.value[i] = dx * (y - from.y) - dy * (x - from.x);
    sides.step_x[i] = -dy * units_per_sample;
    sides.step_y[i] = dx * units_per_sample;
  }
  return sides;
}

// Samples from `begin` to `end`, both included.
struct Run {
  int begin, end;
};

// The samples of a row that may be on the inner side of all three; what is decided exactly comes later.
Run narrowed(const Sides& s, Run row) {
  double low = row.begin;
  double high = row.end;
  for (std::size_t i = 0; i < 3; ++i) {
    const double cut = row.begin - static_cast<double>(s.value[i]) / static_cast<double>(s.step_x[i]);
    if (s.step_x[i] > 0) low = std::max(low, cut - 1);
    if (s.step_x[i] < 0) high = std::min(high, cut + 1);
  }
  if (!(low <= high)) return {0, -1};
  return {static_cast<int>(low), static_cast<int>(high)};
}

// Writes one facet. Depths come from the sample's exact distances, never from a running sum: they do not
// depend on where the tile begins.
class Pen {
 public:
  Pen(const Triangle& t, const Facets& facets, FacetId f, DepthBuffer& buffer);
  void draw(int left, int top);

 private:
  void row(int y, Run run, const Sides& at_begin);
  void touch(std::size_t i, float z);

  std::array<ScreenPoint, 3> p_;
  float nearer_;
  const Facets& facets_;
  FacetId f_;
  DepthBuffer& buffer_;
  double z0_ = 0, slope_1_ = 0, slope_2_ = 0;
};

Pen::Pen(const Triangle& t, const Facets& facets, FacetId f, DepthBuffer& buffer)
    : p_(t.corner), nearer_(t.nearer), facets_(facets), f_(f), buffer_(buffer) {
  // One order of the corners, however the file names them: equal facets get equal depths.
  std::sort(p_.begin(), p_.end(), [](const ScreenPoint& a, const ScreenPoint& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
}

void Pen::touch(std::size_t i, float z) {
  if (z < buffer_.depth[i]) return;
  if (z == buffer_.depth[i] && !comes_first(facets_, f_, buffer_.facet[i])) return;
  buffer_.depth[i] = z;
  buffer_.facet[i] = f_;
}

void Pen::row(int y, Run run, const Sides& at_begin) {
  std::int64_t e0 = at_begin.value[0];
  std::int64_t e1 = at_begin.value[1];
  std::int64_t e2 = at_begin.value[2];
  for (int x = run.begin; x <= run.end; ++x) {
    if ((e0 | e1 | e2) >= 0) {
      const double z = z0_ + static_cast<double>(e1) * slope_1_ + static_cast<double>(e2) * slope_2_;
      touch(Tile::at(x, y), static_cast<float>(z) + nearer_);
    }
    e0 += at_begin.step_x[0], e1 += at_begin.step_x[1], e2 += at_begin.step_x[2];
  }
}

void Pen::draw(int left, int top) {
  const auto [x0, x1] = std::minmax({p_[0].x, p_[1].x, p_[2].x});
  const auto [y0, y1] = std::minmax({p_[0].y, p_[1].y, p_[2].y});
  const Run across{std::max(0, first_sample(x0) - left), std::min(tile_samples - 1, last_sample(x1) - left)};
  const Run down{std::max(0, first_sample(y0) - top), std::min(tile_samples - 1, last_sample(y1) - top)};
  if (across.begin > across.end || down.begin > down.end) return;
  const std::int64_t area = sides_at(p_, p_[0].x, p_[0].y).value[0];
  if (area == 0) return;
  if (area < 0) std::swap(p_[1], p_[2]);
  z0_ = p_[0].z;
  slope_1_ = (p_[1].z - z0_) / std::abs(static_cast<double>(area));
  slope_2_ = (p_[2].z - z0_) / std::abs(static_cast<double>(area));
  constexpr int half = units_per_sample / 2;
  Sides s = sides_at(p_, std::int64_t{across.begin + left} * units_per_sample + half,
                     std::int64_t{down.begin + top} * units_per_sample + half);
  for (int y = down.begin; y <= down.end; ++y) {
    const Run run = across.end - across.begin < 12 ? across : narrowed(s, across);
    Sides at_begin = s;
    for (std::size_t i = 0; i < 3; ++i) at_begin.value[i] += (run.begin - across.begin) * s.step_x[i];
    row(y, run, at_begin);
    for (std::size_t i = 0; i < 3; ++i) s.value[i] += s.step_y[i];
  }
}

}  // namespace

void draw_facet(const Facets& facets, FacetId f, int left, int top, DepthBuffer& buffer) {
  const TriangleMesh& mesh = *facets.drawing->mesh;
  const auto& corners = mesh.facets[f];
  const auto& points = *facets.points;
  Triangle t{{points[corners[0]], points[corners[1]], points[corners[2]]}};
  if (const std::uint8_t mark = mark_of(*facets.drawing, f); mark != 0) {
    t.nearer = head_start(mark, std::max({t.corner[0].z, t.corner[1].z, t.corner[2].z}));
  }
  if (!t.corner[0].far() && !t.corner[1].far() && !t.corner[2].far()) {
    return Pen(t, facets, f, buffer).draw(left, top);
  }
  const auto [a, b, c] = mesh.corners(f);
  std::vector<Vec3d> polygon{facets.screen->place(a), facets.screen->place(b), facets.screen->place(c)};
  std::sort(polygon.begin(), polygon.end(), in_order);
  polygon =
      clipped(std::move(polygon), left - 8.0, top - 8.0, left + tile_samples + 8.0, top + tile_samples + 8.0);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    t.corner = {Screen::snapped(polygon[0]), Screen::snapped(polygon[i - 1]), Screen::snapped(polygon[i])};
    Pen(t, facets, f, buffer).draw(left, top);
  }
}

}  // namespace gabarit
