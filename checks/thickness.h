// Wall thickness, after Inui, Umezu & Shimane, Shrinking sphere: A parallel algorithm for computing the
// thickness of 3D objects (2016). docs/thickness.md has the definition.
#pragma once

#include "checks/check.h"

namespace gabarit {

extern const Measure thickness_measure;

}  // namespace gabarit
