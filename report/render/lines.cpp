#include "report/render/lines.h"

#include <algorithm>
#include <cmath>

#include "report/render.h"

namespace gabarit {

std::vector<PlacedLine> placed(std::span<const SceneLine> lines, const Screen& screen) {
  std::vector<PlacedLine> result;
  for (const SceneLine& line : lines) {
    const PlacedLine p{screen.place(line.from), screen.place(line.to),
                       std::clamp(line.width, 0.0, 1000.0) * samples_per_pixel / 2, line.on_top,
                       light_of(line.colour)};
    if (is_finite(p.from) && is_finite(p.to) && p.radius > 0) result.push_back(p);
  }
  return result;
}

namespace {

struct Span {
  double low, high;
  Span both(const Span& b) const { return {std::max(low, b.low), std::min(high, b.high)}; }
};

// Draws a line in the tile's own coordinates, where sample (0, 0) is at the origin.
class LinePen {
 public:
  LinePen(const PlacedLine& line, Tile& tile)
      : line_(line),
        tile_(tile),
        from_{line.from.x - tile.left - 0.5, line.from.y - tile.top - 0.5, line.from.z},
        along_(line.to - line.from),
        length_(std::hypot(along_.x, along_.y)) {}

  void draw();

 private:
  bool passes_by() const;
  Span row(int y) const;
  void sample(int x, int y);

  const PlacedLine& line_;
  Tile& tile_;
  Vec3d from_, along_;
  double length_;
};

double nearest(double t) { return std::clamp(std::isnan(t) ? 0.0 : t, 0.0, 1.0); }

// The whole tile is farther from the line than it is thick.
bool LinePen::passes_by() const {
  const double middle = tile_samples / 2.0;
  const double dx = middle - from_.x;
  const double dy = middle - from_.y;
  const double t = nearest((dx * along_.x + dy * along_.y) / (length_ * length_));
  return std::hypot(dx - t * along_.x, dy - t * along_.y) > line_.radius + 0.75 * tile_samples;
}

// Where the line's band crosses a row; its round ends reach at most to the ends' own squares.
Span LinePen::row(int y) const {
  const Span box{std::min(from_.x, from_.x + along_.x) - line_.radius,
                 std::max(from_.x, from_.x + along_.x) + line_.radius};
  if (along_.y == 0) return box;
  const double middle = from_.x + (y - from_.y) / along_.y * along_.x;
  const double reach = line_.radius * length_ / std::abs(along_.y);
  return box.both({middle - reach, middle + reach});
}

void LinePen::sample(int x, int y) {
  const double dx = x - from_.x;
  const double dy = y - from_.y;
  const double t = nearest((dx * along_.x + dy * along_.y) / (length_ * length_));
  if (std::hypot(dx - t * along_.x, dy - t * along_.y) > line_.radius) return;
  const std::size_t i = Tile::at(x, y);
  if (!line_.on_top && tile_.front.depth[i] > from_.z + t * along_.z + line_.radius) return;
  tile_.light[i] = line_.light;
  tile_.cover[i] = Cover::symbol;
}

void LinePen::draw() {
  if (passes_by()) return;
  const auto clamped = [](double v) { return static_cast<int>(std::clamp(v, -1.0, tile_samples + 1.0)); };
  const double top = std::min(from_.y, from_.y + along_.y) - line_.radius;
  const double bottom = std::max(from_.y, from_.y + along_.y) + line_.radius;
  for (int y = std::max(0, clamped(top)); y <= std::min(tile_samples - 1, clamped(bottom)); ++y) {
    const Span span = row(y);
    for (int x = std::max(0, clamped(span.low)); x <= std::min(tile_samples - 1, clamped(span.high)); ++x) {
      sample(x, y);
    }
  }
}

}  // namespace

void draw_lines(const std::vector<PlacedLine>& lines, Tile& tile) {
  for (const PlacedLine& line : lines) LinePen(line, tile).draw();
}

}  // namespace gabarit
