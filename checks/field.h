// A measured value per facet of a region, with its bounds and the place that decided it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/triangle_mesh.h"

namespace gabarit {

// Why a facet has bounds but no value.
enum class Absence : std::uint8_t {
  none,        // it has a value
  degenerate,  // the facet has no normal
  open,        // nothing stops the ball: the mesh is open
  too_little,  // the mesh turns too little near the facet to tell
  buried,      // the facet lies inside the part: the mesh overlaps itself
};

// All arrays have one entry a measured facet. Bounds hold the truth: lower <= true value <= upper; a value
// that is not known has NaN, lower 0 (or what is certain) and upper +infinity (or what is certain).
struct Field {
  std::vector<FacetId> facets;  // ascending
  std::vector<double> value, lower, upper;
  std::vector<Vec3d> at;  // where on the facet the deciding value was found; model coordinates
  std::vector<Vec3d>
      contact;  // the other end: the point that stopped the ball, the sharp edge; = at when there is none
  std::vector<Absence> absence;
  std::vector<std::string> notes;  // whole sentences for the report: sampling step, normals used, …

  std::size_t size() const { return facets.size(); }
  void reserve(std::size_t n) {
    facets.reserve(n), value.reserve(n), lower.reserve(n), upper.reserve(n);
    at.reserve(n), contact.reserve(n), absence.reserve(n);
  }
  void resize(std::size_t n) {
    facets.resize(n), value.resize(n), lower.resize(n), upper.resize(n);
    at.resize(n), contact.resize(n), absence.resize(n);
  }
};

}  // namespace gabarit
