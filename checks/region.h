// Which facets a rule looks at.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/triangle_mesh.h"

namespace gabarit {

enum class Selected : std::uint8_t { no = 0, yes = 1, maybe = 2 };

// Three-valued logic: maybe means that the selector's own bounds straddle.
constexpr Selected both(Selected a, Selected b) {
  if (a == Selected::no || b == Selected::no) return Selected::no;
  return a == Selected::maybe || b == Selected::maybe ? Selected::maybe : Selected::yes;
}
constexpr Selected either(Selected a, Selected b) {
  if (a == Selected::yes || b == Selected::yes) return Selected::yes;
  return a == Selected::maybe || b == Selected::maybe ? Selected::maybe : Selected::no;
}
constexpr Selected opposite(Selected a) {
  return a == Selected::yes ? Selected::no : a == Selected::no ? Selected::yes : Selected::maybe;
}

// A curve that shows how a selector came to its answer, such as the path of a column's axis. Model
// coordinates, mm.
struct Trace {
  std::string name;
  std::vector<Vec3d> points;
  bool closed = false;
};

struct Region {
  std::vector<Selected> facets;  // one a facet of the model
  std::vector<std::array<Selected, 3>>
      edges;                 // by facet and edge; empty: an edge is selected as its facet is
  std::vector<float> depth;  // of a contact: mm from the probe to the facet, one a facet; else empty
  std::vector<Trace> traces;
  std::vector<std::string> notes;  // whole sentences for the report

  Selected edge(FacetId f, int e) const {
    return edges.empty() ? facets[f] : edges[f][static_cast<std::size_t>(e)];
  }
};

// Those that are selected or may be, ascending.
std::vector<FacetId> selected_facets(const Region& region);

}  // namespace gabarit
