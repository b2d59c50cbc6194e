// The radius of convex rounding: how sharp a surface is to what touches it from outside.
#pragma once

#include "checks/check.h"

namespace gabarit {

extern const Measure radius_measure;

}  // namespace gabarit
