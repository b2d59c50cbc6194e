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
  // When not empty (one a facet): facets above 0 stay visible however small they are on the page, unless they
  // are hidden: a dot stands for what covers too little. Of equal surfaces the higher number shows. Failing
  // facets: 2, undecided ones: 1.
  std::span<const std::uint8_t> marked;
  bool occlusion = true;  // darken corners, which tells near from far
};

// Shading follows the facet's normal, seen from either side. Facets with a NaN are left out. The scale is
// that of the camera's width. Throws std::length_error for pictures that are not 1 to 8192 pixels wide and
// high. Memory: 12 bytes a vertex, 4 to 64 a facet, 12 a pixel.
Picture render(const Drawing& drawing, const Camera& camera, int width, int height, const Device& device);

}  // namespace gabarit
