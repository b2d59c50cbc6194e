// The samples of one tile of the picture, with its rim: what every step of drawing reads and writes.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "report/picture.h"
#include "report/render/tile_bins.h"

namespace gabarit {

constexpr std::size_t samples_in_tile = std::size_t{tile_samples} * tile_samples;
constexpr FacetId no_facet = std::numeric_limits<FacetId>::max();

// The nearest facet of each sample.
struct DepthBuffer {
  std::vector<float> depth = std::vector<float>(samples_in_tile, -std::numeric_limits<float>::infinity());
  std::vector<FacetId> facet = std::vector<FacetId>(samples_in_tile, no_facet);
};

// Proportional to the light on the page: the square of the channel's value (a gamma of 2, exact to undo).
struct Light {
  std::uint16_t r = 0, g = 0, b = 0;
};

constexpr Light light_of(Rgb c) {
  return {static_cast<std::uint16_t>(c.r * c.r), static_cast<std::uint16_t>(c.g * c.g),
          static_cast<std::uint16_t>(c.b * c.b)};
}

// To the right, up and toward the eye, in 1/127.
struct PageNormal {
  std::int8_t x = 0, y = 0, z = 127;
};

enum class Cover : std::uint8_t {
  paper,   // nothing
  facet,   // shaded, outlined and darkened in corners
  faint,   // the same, but less: not emphasised, or behind something that is not
  symbol,  // a line or a mark: shown in its plain colour
};

struct Tile {
  int left = 0, top = 0;  // of the first sample, in samples of the picture; the rim may be negative
  DepthBuffer front;      // what is seen
  std::vector<Light> light = std::vector<Light>(samples_in_tile);
  std::vector<PageNormal> normal = std::vector<PageNormal>(samples_in_tile);
  std::vector<Cover> cover = std::vector<Cover>(samples_in_tile, Cover::paper);
  // With emphasis: the faint skin in front of an emphasised facet; empty otherwise.
  std::vector<FacetId> skin;

  static std::size_t at(int x, int y) {
    return static_cast<std::size_t>(y) * tile_samples + static_cast<std::size_t>(x);
  }
};

}  // namespace gabarit
