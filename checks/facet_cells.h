// Places on facets where something is measured. A facet that is larger than the step and whose values are not
// settled by one place is cut in halves, again and again.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>

#include "checks/contact_surface.h"
#include "checks/field.h"
#include "checks/region.h"
#include "checks/scene.h"

namespace gabarit {

struct CellQuery {
  Vec3d point;      // the middle of the cell
  Vec3d direction;  // unit, from the surface into what is measured
  Vec3d across;     // the same of the facet alone, where `direction` is that of smooth normals
  FacetId facet = 0;
  std::array<double, 2> weights{};  // of the facet's second and third corner, at the point
  float sag = 0;                    // of the facet, mm
  float spacing = 0;                // from the middle to the farthest corner of the cell, mm
  // Of the facet's other cells so far: an answer that beats neither changes nothing.
  double known = std::numeric_limits<double>::infinity();
  double known_upper = std::numeric_limits<double>::infinity();
  float tilt = 0;  // how far the surface's normals within the cell turn away from the direction, radians
};

struct CellAnswer {
  double value = 0;     // at the point, mm
  double lower = 0;     // over the cell; for the greatest value: at the point
  double upper = 0;     // at the point
  double greatest = 0;  // over the cell
  Vec3d contact;
  Absence absence = Absence::none;
  bool clear = false;  // what matters about the cell is known: eight steps are fine enough for it
  std::optional<Vec3d> at =
      std::nullopt;  // where on the surface itself the value holds; without it the cell's point
};

using Probe = std::function<void(std::span<const CellQuery>, std::span<CellAnswer>)>;

struct CellOptions {
  Side side = Side::inside;
  bool smooth = true;  // normals interpolated from the corners; else those of the facets
  double step = 1;     // mm: cells whose longest side is no longer are not cut
  double limit = 0;    // mm: cells whose bounds it lies between are cut to an eighth of the step; 0: none
  bool exhaustive = false;  // cut down to the step even where the bounds settle the value
  Extreme extreme = Extreme::smallest;
  std::function<void(double fraction)> progress;
};

// One value for every facet that is or may be selected. The same on any number of threads.
Field measure_cells(const TriangleMesh& mesh, const Region& region, const ContactSurface& surface,
                    const CellOptions& options, const Probe& probe);

}  // namespace gabarit
