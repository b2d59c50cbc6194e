#include "report/render/film.h"

#include <algorithm>
#include <cmath>

namespace gabarit {

static constexpr std::array<std::uint32_t, samples_per_pixel + 2> weights{1, 3, 4, 4, 3, 1};  // 16 in all

std::uint8_t channel_of(double light) {
  return static_cast<std::uint8_t>(std::min(255.0, std::sqrt(light) + 0.5));
}

static std::uint32_t averaged(std::uint32_t sum) { return (sum + 128) / 256; }

static Light averaged_light(const Tile& tile, int x, int y) {
  std::uint32_t r = 0;
  std::uint32_t g = 0;
  std::uint32_t b = 0;
  for (std::size_t v = 0; v < weights.size(); ++v) {
    const Light* row = tile.light.data() + Tile::at(x - 1, y - 1 + static_cast<int>(v));
    for (std::size_t u = 0; u < weights.size(); ++u) {
      const std::uint32_t weight = weights[u] * weights[v];
      r += weight * row[u].r, g += weight * row[u].g, b += weight * row[u].b;
    }
  }
  return {static_cast<std::uint16_t>(averaged(r)), static_cast<std::uint16_t>(averaged(g)),
          static_cast<std::uint16_t>(averaged(b))};
}

static std::uint8_t shaded(const Tile& tile, int x, int y) {
  unsigned sum = 0;
  for (int v = 0; v < samples_per_pixel; ++v) {
    for (int u = 0; u < samples_per_pixel; ++u) {
      const Cover cover = tile.cover[Tile::at(x + u, y + v)];
      sum += cover == Cover::facet ? 4 : cover == Cover::faint ? 1 : 0;
    }
  }
  return static_cast<std::uint8_t>(sum);
}

void resolve(const Tile& tile, Film& film) {
  constexpr int rim = rim_pixels * samples_per_pixel;
  const int left = (tile.left + rim) / samples_per_pixel;
  const int top = (tile.top + rim) / samples_per_pixel;
  for (int y = 0; y < std::min(tile_pixels, film.height - top); ++y) {
    for (int x = 0; x < std::min(tile_pixels, film.width - left); ++x) {
      FilmPixel& pixel = film.at(left + x, top + y);
      const int sx = rim + x * samples_per_pixel;
      const int sy = rim + y * samples_per_pixel;
      pixel.light = averaged_light(tile, sx, sy);
      pixel.shaded = shaded(tile, sx, sy);
      pixel.depth = tile.front.depth[Tile::at(sx + samples_per_pixel / 2, sy + samples_per_pixel / 2)] /
                    samples_per_pixel;
    }
  }
}

}  // namespace gabarit
