// Selects what reaches into a band of heights above ground.
#pragma once

#include "checks/check.h"

namespace gabarit {

extern const Selector height_selector;

}  // namespace gabarit
