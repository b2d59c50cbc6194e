// A raster picture: what the renderer draws and the writers place on a page.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gabarit {

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;

  friend bool operator==(const Rgb&, const Rgb&) = default;
};

struct Picture {
  int width = 0, height = 0;  // pixels
  std::vector<Rgb> pixels;    // rows from the top, each from the left

  Rgb& at(int x, int y) {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  const Rgb& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

}  // namespace gabarit
