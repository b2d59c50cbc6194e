// How far each side of the projected facets is from a disk that rolls along a path.
#pragma once

#include <vector>

#include "checks/disk_path.h"
#include "checks/distinct_segments.h"

namespace gabarit {

class ContactDepth {
 public:
  // `radius`: of the disks, roughly.
  ContactDepth(const std::vector<PlanSide>& sides, double radius);

  // dist(side, path) - R in mm for each side; +infinity where that is more than `tolerance`. The disk is
  // empty, so only the ends of arcs and the lines matter: no side comes nearer inside an arc than at its
  // ends.
  std::vector<float> along(const DiskPath& path, double tolerance, const Device& device) const;

 private:
  DistinctSegments sides_;
  SegmentGrid grid_;
};

}  // namespace gabarit
