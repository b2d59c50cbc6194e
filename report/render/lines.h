// Thick lines in space, such as the path of a probe.
#pragma once

#include <vector>

#include "report/render/tile.h"

namespace gabarit {

struct SceneLine;

// A line on the page, in samples; `to` may equal `from`.
struct PlacedLine {
  Vec3d from, to;
  double radius = 1;
  bool on_top = false;
  Light light;
};

// Those that are finite, in the given order.
std::vector<PlacedLine> placed(std::span<const SceneLine> lines, const Screen& screen);

// Later lines cover earlier ones, except that a hidden part covers nothing. A line lies in front of a surface
// that it runs along: it shows where no facet is nearer by more than its radius.
void draw_lines(const std::vector<PlacedLine>& lines, Tile& tile);

}  // namespace gabarit
