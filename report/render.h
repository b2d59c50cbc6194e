// Draws facets without a display or a GPU: depth-buffered, shaded, smooth-edged, the same bytes on any number
// of threads.
#pragma once

#include <span>
#include <vector>

#include "gpu/device.h"
#include "model/triangle_mesh.h"
#include "report/camera.h"
#include "report/picture.h"

namespace gabarit {

struct SceneLine {
  Vec3d from, to;
  Rgb colour;
  double width = 1;     // pixels
  bool on_top = false;  // drawn over everything; otherwise hidden where facets are nearer
};

struct Drawing {
  const TriangleMesh* mesh = nullptr;
  std::span<const Rgb> facet_colours;  // one a facet; empty: all are `plain`
  Rgb plain{178, 190, 202};            // blue-grey
  Rgb background{255, 255, 255};
  std::span<const SceneLine> lines;
  bool outlines = true;  // darken silhouettes and creases, so that a grey print stays readable
  // When not empty (one a facet): facets with 0 are drawn faint and never hide the others' colours; close-ups
  // use it.
  std::span<const std::uint8_t> emphasis;
};

// Facets with a NaN are left out. Shading follows the facet's normal, seen from either side.
Picture render(const Drawing& drawing, const Camera& camera, int width, int height, const Device& device);

}  // namespace gabarit
