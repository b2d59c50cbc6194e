// The width of gaps and slots: thickness outwards.
#pragma once

#include "checks/check.h"

namespace gabarit {

extern const Measure clearance_measure;

}  // namespace gabarit
