#include "report/render/marks.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "report/render.h"

namespace gabarit {
namespace {

constexpr int dot_radius = 5;     // samples
constexpr int window_radius = 4;  // samples: where equally marked surface is looked for
constexpr int enough = 12;        // samples of it, of 81
constexpr double thin = 1.5 * samples_per_pixel;

static_assert(dot_radius + 1 + window_radius <= rim_pixels * samples_per_pixel);

// How many samples of marked surface, of this level or higher, lie in the window around each sample.
std::vector<std::uint16_t> marked_around(const Facets& facets, const Tile& tile, std::uint8_t level) {
  const std::span<const std::uint8_t> marked = facets.drawing->marked;
  std::vector<std::uint16_t> rows(samples_in_tile);
  std::vector<std::uint16_t> around(samples_in_tile);
  const auto is_marked = [&](std::size_t i) {
    const FacetId f = tile.front.facet[i];
    return static_cast<std::uint16_t>(f != no_facet && marked[f] >= level);
  };
  for (int y = 0; y < tile_samples; ++y) {
    unsigned sum = 0;
    for (int x = 0; x < tile_samples + window_radius; ++x) {
      if (x < tile_samples) sum += is_marked(Tile::at(x, y));
      if (x > 2 * window_radius) sum -= is_marked(Tile::at(x - 2 * window_radius - 1, y));
      if (x >= window_radius) rows[Tile::at(x - window_radius, y)] = static_cast<std::uint16_t>(sum);
    }
  }
  for (int x = 0; x < tile_samples; ++x) {
    unsigned sum = 0;
    for (int y = 0; y < tile_samples + window_radius; ++y) {
      if (y < tile_samples) sum += rows[Tile::at(x, y)];
      if (y > 2 * window_radius) sum -= rows[Tile::at(x, y - 2 * window_radius - 1)];
      if (y >= window_radius) around[Tile::at(x, y - window_radius)] = static_cast<std::uint16_t>(sum);
    }
  }
  return around;
}

// A facet so thin on the page that it is taken as its longest side and the two others, in samples of the
// tile.
struct Sliver {
  Vec3d from, to, third;
  double thickness;

  // The nearest it comes to the eye beside the place of the longest side that is closest to a sample.
  double depth(double x, double y) const;
  double distance(double x, double y) const;
  double along(double x, double y) const;
};

double Sliver::along(double x, double y) const {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double square = dx * dx + dy * dy;
  return square > 0 ? ((x - from.x) * dx + (y - from.y) * dy) / square : 0;
}

double mix(double a, double b, double t) { return a + (b - a) * std::clamp(t, 0.0, 1.0); }

double Sliver::depth(double x, double y) const {
  const double knee = along(third.x, third.y);
  const double t = std::clamp(along(x, y), 0.0, 1.0);
  const double other =
      t < knee ? mix(from.z, third.z, t / knee) : mix(third.z, to.z, knee < 1 ? (t - knee) / (1 - knee) : 0);
  const double most = std::max({from.z, to.z, third.z});
  return from.x == to.x && from.y == to.y ? most : std::max(mix(from.z, to.z, t), other);
}

// From a sample to the longest side.
double Sliver::distance(double x, double y) const {
  const double t = std::clamp(along(x, y), 0.0, 1.0);
  return std::hypot(x - mix(from.x, to.x, t), y - mix(from.y, to.y, t));
}

// In the tile's samples, sample (0, 0) at the origin.
Vec3d in_tile(const Facets& facets, const Vec3d& p, const Tile& tile) {
  return facets.screen->place(p) - Vec3d{tile.left + 0.5, tile.top + 0.5, 0};
}

Sliver sliver_of(const Facets& facets, FacetId f, const Tile& tile) {
  std::array<Vec3d, 3> p;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = in_tile(facets, facets.drawing->mesh->corner(f, static_cast<int>(i)), tile);
  }
  const auto square = [&](std::size_t i) {
    const Vec3d d = p[(i + 1) % 3] - p[i];
    return d.x * d.x + d.y * d.y;
  };
  std::size_t longest = square(1) > square(0) ? 1 : 0;
  if (square(2) > square(longest)) longest = 2;
  const Vec3d u = p[(longest + 1) % 3] - p[longest];
  const Vec3d v = p[(longest + 2) % 3] - p[longest];
  const double base = std::sqrt(square(longest));
  return {p[longest], p[(longest + 1) % 3], p[(longest + 2) % 3],
          base > 0 ? std::abs(u.x * v.y - u.y * v.x) / base : 0};
}

// The dots of one level.
class Stamps {
 public:
  Stamps(const Facets& facets, Tile& tile) : drawing_(*facets.drawing), facets_(facets), tile_(tile) {}

  // Puts a centre wherever the facet shows too little.
  void add(FacetId f, const std::vector<std::uint16_t>& around);
  // Draws a dot around every centre.
  void show();

 private:
  Rgb colour(FacetId f) const {
    return drawing_.facet_colours.empty() ? drawing_.plain : drawing_.facet_colours[f];
  }
  bool hides(std::size_t sample, FacetId f, float depth) const;
  bool hidden(FacetId f, int x, int y, float depth) const;
  void claim(FacetId& owner, FacetId f) const;
  void dot(FacetId f, int x, int y, std::vector<FacetId>& owner) const;

  const Drawing& drawing_;
  const Facets& facets_;
  Tile& tile_;
  std::vector<FacetId> centre_ = std::vector<FacetId>(samples_in_tile, no_facet);
};

bool Stamps::hides(std::size_t sample, FacetId f, float depth) const {
  const FacetId front = tile_.front.facet[sample];
  if (front == no_facet || tile_.front.depth[sample] <= depth) return false;
  // What is faint hides nothing that is emphasised.
  return drawing_.emphasis.empty() || drawing_.emphasis[f] == 0 || drawing_.emphasis[front] != 0;
}

// Nothing within a sample lets it show.
bool Stamps::hidden(FacetId f, int x, int y, float depth) const {
  for (int v = std::max(0, y - 1); v <= std::min(tile_samples - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(tile_samples - 1, x + 1); ++u) {
      if (!hides(Tile::at(u, v), f, depth)) return false;
    }
  }
  return true;
}

// Where dots of one level meet, the colour decides, not the order of the facets.
void Stamps::claim(FacetId& owner, FacetId f) const {
  if (owner == f) return;
  if (owner != no_facet) {
    const Rgb a = colour(f);
    const Rgb b = colour(owner);
    if (std::tie(a.r, a.g, a.b) >= std::tie(b.r, b.g, b.b)) return;
  }
  owner = f;
}

void Stamps::dot(FacetId f, int x, int y, std::vector<FacetId>& owner) const {
  for (int v = std::max(0, y - dot_radius); v <= std::min(tile_samples - 1, y + dot_radius); ++v) {
    for (int u = std::max(0, x - dot_radius); u <= std::min(tile_samples - 1, x + dot_radius); ++u) {
      if ((u - x) * (u - x) + (v - y) * (v - y) > dot_radius * dot_radius) continue;
      claim(owner[Tile::at(u, v)], f);
    }
  }
}

void Stamps::add(FacetId f, const std::vector<std::uint16_t>& around) {
  const Sliver sliver = sliver_of(facets_, f, tile_);
  if (!(sliver.thickness <= thin)) return;
  const double reach = sliver.thickness + 0.75;
  const auto low = min(min(sliver.from, sliver.to), sliver.third);
  const auto high = max(max(sliver.from, sliver.to), sliver.third);
  const auto clamped = [](double v) { return static_cast<int>(std::clamp(v, -2.0, tile_samples + 1.0)); };
  for (int y = std::max(0, clamped(low.y - 1)); y <= std::min(tile_samples - 1, clamped(high.y + 1)); ++y) {
    for (int x = std::max(0, clamped(low.x - 1)); x <= std::min(tile_samples - 1, clamped(high.x + 1)); ++x) {
      if (around[Tile::at(x, y)] >= enough || sliver.distance(x, y) > reach) continue;
      const auto depth = static_cast<float>(sliver.depth(x, y));
      if (hidden(f, x, y, depth + head_start(drawing_.marked[f], depth))) continue;
      claim(centre_[Tile::at(x, y)], f);
    }
  }
}

void Stamps::show() {
  std::vector<FacetId> owner(samples_in_tile, no_facet);
  for (int y = 0; y < tile_samples; ++y) {
    for (int x = 0; x < tile_samples; ++x) {
      if (const FacetId f = centre_[Tile::at(x, y)]; f != no_facet) dot(f, x, y, owner);
    }
  }
  for (std::size_t i = 0; i < samples_in_tile; ++i) {
    if (owner[i] == no_facet) continue;
    tile_.light[i] = light_of(colour(owner[i]));
    tile_.cover[i] = Cover::symbol;
  }
}

}  // namespace

void stamp_marks(const Facets& facets, std::span<const FacetId> listed, std::span<const FacetId> large,
                 Tile& tile) {
  const std::span<const std::uint8_t> marked = facets.drawing->marked;
  if (marked.empty()) return;
  std::array<bool, 256> present{};
  for (const auto& list : {listed, large}) {
    for (const FacetId f : list) present[marked[f]] = true;
  }
  for (unsigned level = 1; level < present.size(); ++level) {
    if (!present[level]) continue;
    Stamps stamps(facets, tile);
    const auto around = marked_around(facets, tile, static_cast<std::uint8_t>(level));
    for (const auto& list : {listed, large}) {
      for (const FacetId f : list) {
        if (marked[f] == level) stamps.add(f, around);
      }
    }
    stamps.show();
  }
}

}  // namespace gabarit
