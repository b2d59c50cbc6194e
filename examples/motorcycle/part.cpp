#include "examples/motorcycle/part.h"

namespace gabarit::motorcycle {

const char* name(Expectation expectation) {
  switch (expectation) {
    case Expectation::violates: return "violates";
    case Expectation::round: return "round";
    case Expectation::rear_facing: return "faces rearward";
    case Expectation::out_of_reach: return "out of reach";
  }
  return "";
}

void add_pair(Parts& parts, const Part& right) {
  Part left = right;
  left.name += ", left";
  for (Surface& surface : left.surfaces) surface = mirrored(surface);
  parts.push_back(right);
  parts.back().name += ", right";
  parts.push_back(std::move(left));
}

}  // namespace gabarit::motorcycle
