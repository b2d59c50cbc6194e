// Where the points of a model come to lie in the grid of samples that a picture is averaged from. Positions
// are snapped to whole units, so that which samples a facet covers is decided in integers: no cracks between
// neighbours, and the same answer wherever the tiles are cut.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "gpu/device.h"
#include "model/triangle_mesh.h"
#include "report/camera.h"

namespace gabarit {

constexpr int samples_per_pixel = 4;   // along each axis
constexpr int units_per_sample = 256;  // a shift by 8

// Positions past this are clamped: the side on which they lie is all that is left of them.
constexpr std::int32_t farthest_unit = 1 << 25;

struct ScreenPoint {
  std::int32_t x = 0, y = 0;  // units to the right of and below the picture's upper left corner
  float z = 0;                // samples toward the eye from the camera's target

  // Not finite in the model or not finite when projected.
  bool nowhere() const { return x == std::numeric_limits<std::int32_t>::min(); }
  bool far() const {
    return x <= -farthest_unit || x >= farthest_unit || y <= -farthest_unit || y >= farthest_unit;
  }
};

// Samples are in the middle of their cells. The first at or past a position, and the last at or before it.
constexpr int first_sample(std::int32_t units) { return (units + units_per_sample / 2 - 1) >> 8; }
constexpr int last_sample(std::int32_t units) { return (units - units_per_sample / 2) >> 8; }

class Screen {
 public:
  // The picture's width is the camera's; pixels are square, whatever the camera's height says.
  Screen(const Camera& camera, int width, int height);

  bool valid() const;                          // false: the camera shows nothing
  Vec3d place(const Vec3d& p) const;           // samples: right, down, toward the eye
  Vec3f page_direction(const Vec3d& d) const;  // right, up, toward the eye
  static ScreenPoint snapped(const Vec3d& place);

  int width() const { return width_; }  // pixels
  int height() const { return height_; }

 private:
  Vec3d target_, right_, up_, toward_;
  double scale_;  // samples a millimetre
  int width_, height_;
};

// One a vertex of the mesh; vertices that no facet uses too.
std::vector<ScreenPoint> on_screen(const TriangleMesh& mesh, const Screen& screen, const Device& device);

}  // namespace gabarit
