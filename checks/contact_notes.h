// What a contact tells beside its facets: the path of the column's axis, and sentences for the report.
#pragma once

#include <string>
#include <vector>

#include "checks/disk_path.h"
#include "checks/frame.h"
#include "checks/plan_projection.h"
#include "checks/region.h"

namespace gabarit {

// One trace for each contour, or for each run of pieces that join end to end, on the ground, in model
// coordinates; chords of arcs leave them by 1 mm at most.
std::vector<Trace> contact_traces(const DiskPath& path, const Frame& frame);

// How many outlines there are, what was left out, and where the sag decides about a contact. `spacing`: of
// the dexels that the path comes from, 0 for none.
std::vector<std::string> contact_notes(const Region& region, const TriangleMesh& mesh,
                                       const PlanProjection& plan, const DiskPath& path, double spacing);

}  // namespace gabarit
