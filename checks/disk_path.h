// The path of the centre of a disk that rolls along an outline from outside: where it touches and overlaps
// nothing.
#pragma once

#include <cstdint>
#include <vector>

#include "checks/outline_features.h"
#include "checks/reach_grid.h"
#include "gpu/device.h"

namespace gabarit {

// A piece of the path: an arc around a point of the outline or a line beside one of its edges.
struct PathPiece {
  Point2 from, to;
  Point2 centre;                        // of an arc
  double from_angle = 0, to_angle = 0;  // of an arc, ascending
  bool arc = false;
  Point2 foot;                  // a point of the feature that is touched at `from`
  std::uint32_t component = 0;  // of the path; pieces that join end to end share it
  bool cut = false;             // goes on where no disk from outside can be
};

// A line through places of a path that is known in places only, for pictures.
struct Contour {
  std::vector<Point2> points;
  bool closed = false;  // the last point is the first
};

struct DiskPath {
  double radius = 0;
  std::vector<PathPiece> pieces;  // reachable from outside only
  std::uint32_t components = 0;   // of the reachable path
  std::vector<Contour> contours;  // when the pieces are places of no length
};

// The boundary of the part of { c : dist(c, outline) >= radius } that is connected to infinity. Gaps of
// exactly 2 * radius are open: whether two features leave room for the disk is decided exactly; positions are
// good to about 1e-9 mm.
// `reach`, when given, saves looking at places that the disk cannot get to; it must hold for this radius.
DiskPath disk_path(const OutlineFeatures& outline, double radius, const Device& device,
                   const ReachGrid* reach = nullptr);

}  // namespace gabarit
