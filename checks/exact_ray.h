// Where a ray that starts on an exact surface meets the trimmed faces of the model first. Facets only say
// where to look: every face with a facet near the ray is met by Newton's method from there, and its trimming
// curves decide.
#pragma once

#include <span>
#include <vector>

#include "checks/exact_model.h"
#include "gpu/bvh.h"

namespace gabarit {

struct ExactRayQuery {
  Vec3d point, direction;  // unit
  FaceId face = 0;         // that the point lies on
};

struct ExactRayOptions {
  double sign = 1;   // 1: outward normals point along the ray where it ends; -1: against it
  double floor = 0;  // mm: hits this close to the point are the surface that the ray starts on
  double slack = 0;  // mm: how far a face may reach beside its facets
  double greatest = std::numeric_limits<double>::infinity();  // mm: farther hits are not looked for
};

struct ExactRayView : ExactModelView {
  BvhView tree;  // of the facets; the ids of other primitives are greater
};

struct ExactRay {
  double distance = std::numeric_limits<double>::infinity();  // infinite: it meets nothing
  // How much farther the end may be, where the ray runs so near to a trimming curve that tolerance decides.
  double open = 0;
  Vec3d end;
  FaceId face = no_number;
  bool right =
      false;  // it ends where the side that is measured ends: it does not run into a face from behind
  bool verified = false;  // every facet that it crosses before its end was explained by a face that it meets
};

// Answers in the order of the queries, computed on the device where both the tree of the model's facets and
// its exact faces are; neighbouring queries should lie close together. The same bits on every device and any
// number of threads. Throws DeviceError and OutOfDeviceMemory.
void exact_rays(const Bvh& tree, const ExactModel& exact, const ExactRayOptions& options,
                std::span<const ExactRayQuery> queries, std::span<ExactRay> rays);

}  // namespace gabarit
