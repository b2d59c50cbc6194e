// The arrays of a Brep as kernels hold them.
#pragma once

#include "gpu/view.h"
#include "model/brep.h"

namespace gabarit {

struct BrepView {
  View<const Surface> surfaces;
  View<const Curve> curves;
  View<const Pole> poles;
  View<const double> knots;
  View<const Face> faces;
  View<const Edge> edges;
  View<const BrepVertex> vertices;
  View<const std::uint32_t> first_edge_of_face;
  View<const EdgeId> edges_of_face;
  View<const FaceTrim> trims;
  View<const TrimPiece> trim_pieces;
  View<const std::uint32_t> trim_bins, trim_listing;
};
// In the memory of the CPU, valid as long as the arrays of `brep` are not changed.
BrepView view(const Brep& brep);

}  // namespace gabarit
