// Whether a device can be trusted.
#pragma once

#include <string>

#include "gpu/device.h"

namespace gabarit {

// Builds a small tree, asks every kind of query on the device and on the CPU and compares the bits. Empty
// when all are equal, else a sentence that names what is wrong. Throws nothing of a device that fails.
std::string trial_of(const Device& device);

}  // namespace gabarit
