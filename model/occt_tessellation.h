// Facets of exact surfaces.
#pragma once

#include <Message_ProgressRange.hxx>
#include <TopoDS_Shape.hxx>

#include "model/model.h"

namespace gabarit {

struct TessellationOptions {
  double sag = 0.05;              // mm, asked for
  double angle = 0.349065850399;  // radians between neighbouring facets across a curved face: 20°
};

struct Tessellation {
  std::uint64_t faces_without = 0;    // faces that OpenCASCADE could not mesh
  std::uint64_t edges_unmatched = 0;  // edges whose two faces disagree: the mesh is open there
};

// Makes the triangulation of every face, in the shape itself.
void triangulate(const TopoDS_Shape& shape, const TessellationOptions& options,
                 const Message_ProgressRange& progress);

// Appends the facets of the shape as body `body`, each with its face, `first_face` + its place among the
// faces of the shape. Facets share vertices along edges by topology, not by distance; facets without area at
// poles are not made.
Tessellation append_facets(const TopoDS_Shape& shape, std::uint32_t body, FaceId first_face,
                           TriangleMesh& mesh, std::vector<FacetOrigin>& origins);

}  // namespace gabarit
