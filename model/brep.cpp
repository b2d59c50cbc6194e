#include "model/brep.h"

#include "model/brep_view.h"

namespace gabarit {

const char* name(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::plane: break;
    case SurfaceKind::cylinder: return "cylinder";
    case SurfaceKind::cone: return "cone";
    case SurfaceKind::sphere: return "sphere";
    case SurfaceKind::torus: return "torus";
    case SurfaceKind::extrusion: return "extrusion";
    case SurfaceKind::revolution: return "revolution";
    case SurfaceKind::spline: return "spline";
  }
  return "plane";
}

const char* name(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::smooth: break;
    case EdgeKind::convex: return "convex";
    case EdgeKind::concave: return "concave";
    case EdgeKind::mixed: return "mixed";
    case EdgeKind::boundary: return "boundary";
  }
  return "smooth";
}

template <class T>
static View<const T> elements(const std::vector<T>& of) {
  return {of.data(), static_cast<std::int64_t>(of.size())};
}

BrepView view(const Brep& brep) {
  return {elements(brep.surfaces),      elements(brep.curves),
          elements(brep.poles),         elements(brep.knots),
          elements(brep.faces),         elements(brep.edges),
          elements(brep.vertices),      elements(brep.first_edge_of_face),
          elements(brep.edges_of_face), elements(brep.trims),
          elements(brep.trim_pieces),   elements(brep.trim_bins),
          elements(brep.trim_listing)};
}

}  // namespace gabarit
