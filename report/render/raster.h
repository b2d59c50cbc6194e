// Draws facets into the depth buffer of a tile.
#pragma once

#include <span>

#include "report/render/tile.h"

namespace gabarit {

struct Drawing;

// What the rasteriser reads.
struct Facets {
  const Drawing* drawing;
  const Screen* screen;
  const std::vector<ScreenPoint>* points;
};

// How much nearer a marked facet counts than it is, in samples: it wins against an equal surface.
float head_start(std::uint8_t mark, float depth);

// Of facets that are equally near at a sample: the higher mark, then the one that faces the eye, then by
// normal and colour, which makes the picture independent of the order of the facets, then the lower number.
bool comes_first(const Facets& facets, FacetId a, FacetId b);

// Covers the samples that lie in the facet, border included, where it is nearest.
void draw_facet(const Facets& facets, FacetId f, int left, int top, DepthBuffer& buffer);

}  // namespace gabarit
