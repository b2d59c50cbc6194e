// The picture while it is made: the light of each pixel, averaged from its samples, and how far away it is.
#pragma once

#include <limits>
#include <vector>

#include "report/render/tile.h"

namespace gabarit {

struct FilmPixel {
  Light light;
  std::uint8_t shaded = 0;  // 4 for each of the 16 samples that shows a facet, 1 where it is faint
  float depth = -std::numeric_limits<float>::infinity();  // pixels toward the eye, in the middle of the pixel
};

struct Film {
  int width = 0, height = 0;
  std::vector<FilmPixel> pixels;

  Film(int w, int h, Light paper)
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {
    for (FilmPixel& pixel : pixels) pixel.light = paper;
  }
  FilmPixel& at(int x, int y) {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  const FilmPixel& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

// Averages a tile's samples into its pixels. The filter reaches one sample past the pixel and falls off
// there: 36 samples, 16 of them in the pixel itself, in whole numbers.
void resolve(const Tile& tile, Film& film);

// The square root undoes the square of light_of.
std::uint8_t channel_of(double light);

}  // namespace gabarit
