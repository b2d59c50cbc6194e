// The solids that the vehicle is made of. All are closed; their true radii are those of the outlines and
// profiles.
#pragma once

#include <array>
#include <vector>

#include "examples/motorcycle/outline.h"
#include "examples/motorcycle/placement.h"
#include "examples/motorcycle/surface.h"

namespace gabarit::motorcycle {

// A profile of (radius, height) turned about z. Open, from the lower to the upper point on the axis; or a
// closed counter-clockwise one beside the axis, which gives a ring.
Surface revolved(const Outline& profile, const Placement& place);
Surface turned_ring(const Outline& profile, const Placement& place);

// A counter-clockwise outline in x-y, carried upwards along z. The profile is open and gives (inset, height):
// how far the edge has moved inward. Both faces are filled from `centre`, which must see all of the outline.
// Insets must be smaller than the outline's convex radii.
Surface prism(const Outline& outline, const Outline& profile, Vec2 centre, const Placement& place);

// A plate from z = 0 to `thickness`, both edges rounded by `edge` (0: sharp; thickness / 2: full round).
Surface plate(const Outline& outline, double thickness, double edge, Vec2 centre, const Placement& place);
// A box about the origin, all edges rounded by `edge`, the four upright ones by `corner` (at least `edge`).
Surface rounded_box(const Vec3d& size, double corner, double edge, const Placement& place);

// What a tube ends in.
struct TubeEnds {
  double first = 0, last = 0;  // radius of the edge; the tube's radius: a hemisphere; 0: sharp
};
Surface tube(const Path& path, double radius, TubeEnds ends);
// A profile of (radius, length along the path), from axis to axis.
Surface turned_along(const Path& path, const Outline& profile);
// An outline carried along a path; both end edges rounded by `edge`.
Surface swept(const Path& path, const Outline& section, double edge);

// A freeform body: the tensor product of cubic B-splines through control sections. It is symmetric about y =
// 0.
struct Section {
  double x;
  std::vector<Vec2> half;  // control points (y, z) from the lowest to the highest on the side of y > 0
};
// An end closes as a dome: an ellipse of control points and the tip's control point.
struct Dome {
  double tip_x, x;
  Vec2 centre;  // (y, z)
  double half_width, half_height;
};
// All sections have the same number of points; x increases from `front` to `rear`.
Surface lofted(const Dome& front, const std::vector<Section>& sections, const Dome& rear);

}  // namespace gabarit::motorcycle
