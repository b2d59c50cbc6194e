// Reads shares and colours off pictures, for the tests of the renderer.
#pragma once

#include <vector>

#include "report/render.h"
#include "tests/shapes.h"

namespace gabarit {

// Looks down from +z at the origin: x to the right, y up.
Camera from_above(double width, double aspect = 1);

// Red paper and blue facets, which keep a red channel of 0 however they are lit, without lines and shadows.
Drawing blue_on_red(const TriangleMesh& mesh);

// Of the paper in a pixel of such a picture, 0 to 1; of the facets in the whole picture, in pixels.
double paper_share(Rgb pixel);
double covered_pixels(const Picture& picture);

bool is_reddish(Rgb pixel);  // red outweighs green and blue clearly
int count_reddish(const Picture& picture);

}  // namespace gabarit
