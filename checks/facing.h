// Selects what faces a direction.
#pragma once

#include "checks/check.h"

namespace gabarit {

extern const Selector facing_selector;

}  // namespace gabarit
