// Every device at hand whose bits have to be those of one CPU thread with portable instructions.
#pragma once

#include <string>
#include <vector>

#include "gpu/device_memory.h"

namespace gabarit {

struct NamedDevice {
  std::string name;
  Device device;
};

const Device plain_cpu{.threads = 1, .vectors = VectorSet::portable};

// What this CPU lacks falls back to what it has.
inline std::vector<NamedDevice> other_devices() {
  std::vector<NamedDevice> all{{"two threads", {.threads = 2, .vectors = VectorSet::portable}},
                               {"AVX2", {.threads = 1, .vectors = VectorSet::avx2}},
                               {"AVX-512", {.threads = 1, .vectors = VectorSet::avx512}},
                               {"a simulated device", Device::simulated(1)},
                               {"a simulated device, two threads", Device::simulated(2)}};
  const int found = static_cast<int>(cuda_devices().size());
  for (int i = 0; i < found; ++i) all.push_back({"CUDA device " + std::to_string(i), Device::cuda(i, 1)});
  return all;
}

}  // namespace gabarit
