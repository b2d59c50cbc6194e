// The pieces of a Brep's edges along the sides of its facets, and the corners where edges end.
#pragma once

#include "checks/exact_surface.h"

namespace gabarit {

struct EdgePieces {
  std::vector<EdgePiece> pieces;
  std::vector<std::array<VertexId, 2>> ends;  // of each piece, vertices of the mesh
  std::vector<double> sags;                   // of each piece: how far the curve lies from the straight line
  std::vector<double> facet_sags;  // by facet: how far a curve lies from its sides, 0 where they are no edges
};

// One where facets of two faces share a side, and at free sides.
EdgePieces edge_pieces(const Model& model);

struct EdgeCorners {
  std::vector<EdgeCorner> corners;
  std::vector<VertexId> vertices;
  std::vector<Vec3d> directions;
};

// Every vertex where pieces meet that do not belong to one edge.
EdgeCorners edge_corners(const Model& model, const EdgePieces& pieces);

}  // namespace gabarit
