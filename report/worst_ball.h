// The ball behind a worst value of thickness or clearance, for a drawing of it.
#pragma once

#include <optional>

#include "report/camera.h"
#include "rules/outcome.h"

namespace gabarit {

struct WorstBall {
  Vec3d touch, contact;  // O, the place that was measured, and the point that stopped the ball
  Vec3d direction;       // unit, from O to the centre of the ball, or along the ray
  double diameter = 0;   // mm
  bool ball = true;      // false: measured along a ray, the diameter is the distance
  double limit = 0;  // mm: the diameter that the rule asks for, the one that is nearest when it asks for two

  Vec3d centre() const { return touch + direction * (diameter / 2); }
};

// None for other measures, and where the value or a place is not known or without bound. The direction is the
// one that puts O and the contact on the ball, next to the facet's own normal.
std::optional<WorstBall> worst_ball(const TriangleMesh& mesh, const RuleResult& result, const Worst& worst);

// Looks squarely at the plane of O, the contact and the direction, O above the ball; room for the ball and
// for the one that the limit asks for. Where the contact lies opposite O every plane along the direction
// holds it: the one across the longest extent of the part is taken.
Camera section_camera(const WorstBall& ball, const Box3d& part, double aspect);

}  // namespace gabarit
