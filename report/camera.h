// An orthographic view of the model: lengths in the picture are to scale.
#pragma once

#include <string>
#include <vector>

#include "checks/frame.h"
#include "gpu/box.h"
#include "model/triangle_mesh.h"

namespace gabarit {

struct Camera {
  Vec3d target;      // in the middle of the picture, mm
  Vec3d right, up;   // unit, orthogonal: directions on the page; the eye looks along -toward()
  double width = 1;  // mm across the picture
  double height = 1;

  Vec3d toward() const { return cross(right, up); }  // from the model to the eye
};

struct NamedView {
  std::string name;  // such as "front left, from above"
  Camera camera;
};

// The views of a report: front, rear, left, right, top, bottom, then front left and rear right from above;
// each shows the whole box with a margin at the picture's aspect (width / height).
std::vector<NamedView> fixed_views(const Box3d& box, const Frame& frame, double aspect);
// The same for the facets themselves: closer where the box has empty corners.
std::vector<NamedView> fixed_views(const TriangleMesh& mesh, const Frame& frame, double aspect);

// A close-up: looks against `outward` (as far as that can be told from straight up), `extent` mm across.
Camera close_up(const Vec3d& at, const Vec3d& outward, const Frame& frame, double extent, double aspect);

// mm on the page to the right of and above the middle of the picture.
struct PagePoint {
  double x = 0, y = 0;
};
PagePoint project(const Camera& camera, const Vec3d& point);

}  // namespace gabarit
