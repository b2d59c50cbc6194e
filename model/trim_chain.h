// Puts the curves of a wire one behind the other in the plane of parameters.
#pragma once

#include <vector>

#include "model/trim_loops.h"

namespace gabarit {

// A wire in order, each stretch in the turn in which it begins where the one before ends.
struct TrimLoop {
  TrimWire stretches;
  double u_turns = 0, v_turns = 0;  // that the end lies beyond the start
};

// `turn`: the periods, 0 where there is none. Moves the curves of stretches by whole turns.
TrimLoop chained(const TrimWire& wire, const Face& face, Parameters turn, Brep& brep);

}  // namespace gabarit
