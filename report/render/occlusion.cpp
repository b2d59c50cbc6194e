#include "report/render/occlusion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

constexpr int directions = 6;

struct Offset {
  int x, y;
};

// Half of the pairs' ends: the other ends lie opposite.
struct Ring {
  float radius;  // pixels
  std::array<Offset, directions> ends;
};

// Turned against each other, so that what they shut off does not add up to visible copies of an edge.
constexpr std::array rings{Ring{2, {{{2, 0}, {2, 1}, {1, 2}, {0, 2}, {-1, 2}, {-2, 1}}}},
                           Ring{4, {{{4, 1}, {3, 3}, {1, 4}, {-1, 4}, {-3, 3}, {-4, 1}}}},
                           Ring{7, {{{7, 0}, {6, 4}, {4, 6}, {0, 7}, {-4, 6}, {-6, 4}}}},
                           Ring{11, {{{11, 2}, {8, 8}, {2, 11}, {-4, 10}, {-8, 8}, {-11, 2}}}},
                           Ring{16, {{{16, 1}, {14, 8}, {7, 14}, {-1, 16}, {-8, 14}, {-14, 7}}}},
                           Ring{23, {{{22, 7}, {16, 17}, {5, 22}, {-7, 22}, {-17, 16}, {-22, 6}}}}};

// How much a pair shuts off, from how deep the pixel lies under it in units of the ring's radius.
float shut_off(float depth) {
  if (!(depth > 0.04F)) return 0;
  return depth < 0.8F ? depth - 0.04F : std::max(0.0F, 0.76F - (depth - 0.8F) / 2);
}

float pair_depth(const Film& film, int x, int y, Offset o) {
  const auto inside = [&](int u, int v) { return u >= 0 && v >= 0 && u < film.width && v < film.height; };
  if (!inside(x + o.x, y + o.y) || !inside(x - o.x, y - o.y)) return 0;
  const float here = film.at(x, y).depth;
  const float a = film.at(x + o.x, y + o.y).depth;
  const float b = film.at(x - o.x, y - o.y).depth;
  return 0.5F * (a + b) - here;  // -infinity where one of them is paper
}

// 1 where nothing is shut off.
float openness(const Film& film, int x, int y) {
  float sum = 0;
  for (const Ring& ring : rings) {
    for (const Offset& o : ring.ends) sum += shut_off(pair_depth(film, x, y, o) / ring.radius);
  }
  return 1 - std::min(0.6F, 1.9F * sum / (directions * rings.size()));
}

Rgb developed_pixel(const Film& film, int x, int y, bool occlusion) {
  const FilmPixel& pixel = film.at(x, y);
  float rest = 1;
  if (occlusion && pixel.shaded > 0 && std::isfinite(pixel.depth)) {
    rest -= (1 - openness(film, x, y)) * static_cast<float>(pixel.shaded) / 64;
  }
  return {channel_of(pixel.light.r * rest), channel_of(pixel.light.g * rest),
          channel_of(pixel.light.b * rest)};
}

}  // namespace

Picture developed(const Film& film, bool occlusion, const Device& device) {
  Picture picture{film.width, film.height, std::vector<Rgb>(film.pixels.size())};
  const auto row = [&](std::int64_t y) {
    for (int x = 0; x < film.width; ++x) {
      picture.at(x, static_cast<int>(y)) = developed_pixel(film, x, static_cast<int>(y), occlusion);
    }
  };
  parallel_for_cpu(device, film.height, row, 16);
  return picture;
}

}  // namespace gabarit
