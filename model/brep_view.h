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
};
// In the memory of the CPU, valid as long as the arrays of `brep` are not changed.
BrepView view(const Brep& brep);

}  // namespace gabarit
