// How far each side of the projected facets is from a disk that rolls along a path.
#pragma once

#include <vector>

#include "checks/disk_path.h"
#include "checks/distinct_segments.h"
#include "gpu/rolling_depth.h"

namespace gabarit {

class ContactDepth {
 public:
  // `radius`: of the disks, roughly. Throws DeviceError and OutOfDeviceMemory.
  ContactDepth(const std::vector<PlanSide>& sides, double radius, const Device& device);
  ContactDepth(const ContactDepth&) = delete;
  ContactDepth& operator=(const ContactDepth&) = delete;

  // dist(side, path) - R in mm for each side; +infinity where that is more than `tolerance`. The disk is
  // empty, so only the ends of arcs and the lines matter: no side comes nearer inside an arc than at its
  // ends.
  // `apart`: the pieces are places that touch, such as those of dexels, and from any other place of the path
  // there is one within so much (see RollingDepth).
  std::vector<float> along(const DiskPath& path, double tolerance, double apart = 0) const;

 private:
  DistinctSegments sides_;
  SegmentGrid grid_;
  RollingDepth rolling_;
};

}  // namespace gabarit
