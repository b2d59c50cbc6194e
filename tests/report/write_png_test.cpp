#include "report/write_png.h"

#include <gtest/gtest.h>
#include <png.h>

namespace gabarit {
namespace {

Picture pattern(int width, int height) {
  Picture picture{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture.pixels.push_back({static_cast<std::uint8_t>(7 * x), static_cast<std::uint8_t>(11 * y),
                                static_cast<std::uint8_t>(x * y)});
    }
  }
  return picture;
}

Picture decoded(const std::string& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
  image.format = PNG_FORMAT_RGB;
  Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.pixels.resize(static_cast<std::size_t>(image.width) * image.height);
  EXPECT_NE(png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr), 0);
  return picture;
}

TEST(png_bytes, hold_every_pixel_of_the_picture) {
  for (const auto& [width, height] : {std::pair{1, 1}, {37, 5}, {5, 37}, {640, 3}}) {
    const Picture picture = pattern(width, height);
    const Picture back = decoded(png_bytes(picture));
    EXPECT_EQ(back.width, width);
    EXPECT_EQ(back.height, height);
    EXPECT_EQ(back.pixels, picture.pixels);
  }
}

TEST(png_bytes, are_the_same_each_time_and_know_no_clock) {
  const std::string bytes = png_bytes(pattern(20, 10));
  EXPECT_EQ(bytes, png_bytes(pattern(20, 10)));
  EXPECT_EQ(bytes.find("tIME"), std::string::npos);
}

TEST(png_bytes, of_no_pixels_are_an_error) { EXPECT_THROW(png_bytes(Picture{}), std::runtime_error); }

}  // namespace
}  // namespace gabarit
