#include "tests/report/picture_checks.h"

#include <algorithm>

namespace gabarit {

Camera from_above(double width, double aspect) {
  return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, width, width / aspect};
}

Drawing blue_on_red(const TriangleMesh& mesh) {
  Drawing drawing;
  drawing.mesh = &mesh;
  drawing.plain = {0, 0, 255};
  drawing.background = {255, 0, 0};
  drawing.outlines = drawing.occlusion = false;
  return drawing;
}

double paper_share(Rgb pixel) { return pixel.r * pixel.r / 65025.0; }

double covered_pixels(const Picture& picture) {
  double sum = 0;
  for (const Rgb pixel : picture.pixels) sum += 1 - paper_share(pixel);
  return sum;
}

bool is_reddish(Rgb pixel) { return pixel.r > pixel.g + 40 && pixel.r > pixel.b + 40; }

int count_reddish(const Picture& picture) {
  return static_cast<int>(std::count_if(picture.pixels.begin(), picture.pixels.end(), is_reddish));
}

}  // namespace gabarit
