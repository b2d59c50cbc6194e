// The one place that says which devices there are and which one a run uses.
#pragma once

#include <string>

#include "gpu/device.h"

namespace gabarit {

// "auto", "cpu" or "cuda"; throws UsageError for one that can't compute here. A CUDA device has to give the
// bits of the CPU in a short trial first; auto takes the CPU when none does.
Device choose_device(const std::string& name, int threads);

}  // namespace gabarit
