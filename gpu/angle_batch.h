// All angle functions of many numbers, on a device: whether it gives the bits of the CPU can be tried.
#pragma once

#include <span>
#include <vector>

#include "gpu/device.h"

namespace gabarit {

struct AngleValues {
  double sine = 0, cosine = 0;
  double angle = 0;       // of the point (1, x)
  double arc_cosine = 0;  // of x / (1 + |x|)
  double hyperbolic_sine = 0, hyperbolic_cosine = 0;
};

// Throws DeviceError and OutOfDeviceMemory.
std::vector<AngleValues> angle_values(const Device& device, std::span<const double> x);

}  // namespace gabarit
