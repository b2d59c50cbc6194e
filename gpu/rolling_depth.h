// How near a rolling disk comes to segments in the plan.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gpu/device.h"
#include "gpu/segment_squares.h"

namespace gabarit {

// A disk that holds nothing of the segments wherever its centre is on its path.
struct RollingDisk {
  double radius, tolerance;
  // 0: the path is all that is known of it. Else it is places, and from any other place of it there is one of
  // these within so much.
  double apart = 0;
};

class SidesThere;

class RollingDepth {
 public:
  // `squares`: views of the host's memory. They and `segments` must outlive this. Throws DeviceError.
  RollingDepth(const Device& device, const SegmentSquares& squares, std::span<const Segment2> segments);

  // dist(segment, path) - radius for each segment, mm; +infinity where that is more than the tolerance.
  // `centres`: the lines of the path and the ends of its arcs. With places that are apart (of no length),
  // more than the tolerance is infinite only where no place of the path comes nearer: a place cannot get
  // further into what the known one touches, and so hardly nearer to what lies beside that. Segments and
  // centres that do not fit into the device's memory at once are looked at in batches. Throws DeviceError,
  // and OutOfDeviceMemory when not even few fit.
  std::vector<float> along(std::span<const Segment2> centres, const RollingDisk& disk) const;

 private:
  template <class Work>
  void in_parts(Work&& work) const;

  Device device_;
  double size_;  // of a square, mm
  std::span<const Segment2> segments_;
  std::shared_ptr<const SidesThere> all_;  // null when there is no room for all at once
};

}  // namespace gabarit
