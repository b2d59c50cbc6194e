// Dexels in the plane: where the lines of a grid run through a figure (van Hook, Real-Time Shaded NC Milling
// Display, 1986).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/device.h"
#include "gpu/point2.h"
#include "gpu/qualifiers.h"

namespace gabarit {

// Parallel to x, one above the other.
struct DexelLines {
  double first = 0;    // y, mm
  double spacing = 1;  // mm
  std::int64_t count = 0;

  GABARIT_HD double y(std::int64_t line) const { return first + static_cast<double>(line) * spacing; }
};

// A part of a line that lies inside the figure; its ends do not.
struct Dexel {
  double from, to;

  friend bool operator==(Dexel, Dexel) = default;
};

struct Dexels {
  std::vector<std::size_t> first;  // of each line in `all`, and the end
  std::vector<Dexel> all;          // line by line, ascending, disjoint

  std::span<const Dexel> line(std::int64_t i) const {
    const auto n = static_cast<std::size_t>(i);
    return std::span(all).subspan(first[n], first[n + 1] - first[n]);
  }
};

struct PlanEdge {
  Point2 from, to;  // never equal
};

// The figure of all places nearer than `radius` to the points and edges: disks around the points, rectangles
// along the edges (Inui and Umezu, Extraction of Vertical Cylinder Contacting Area for Motorcycle Safety
// Verification). Positions are good to rounding. Every line gathers and unites its own intervals, so no two
// threads meet and the ends are the same bits in whatever order it is done. Lines and features that do not
// fit into the device's memory at once go in batches. Throws DeviceError, and OutOfDeviceMemory when not even
// sixteen lines and few features fit.
Dexels offset_dexels(const Device& device, std::span<const Point2> points, std::span<const PlanEdge> edges,
                     const DexelLines& lines, double radius);

}  // namespace gabarit
