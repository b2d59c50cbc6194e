// The memory of the simulated device: as on a GPU, the CPU's own code cannot look into it.
#pragma once

#include <cstddef>

namespace gabarit {

// Whole pages that may be touched only while a SimulatedAccess lives; null when there is not enough memory.
void* allocate_simulated(std::size_t bytes);
void release_simulated(void* data);

// What kernels and copies hold. Anything else that follows a pointer of the device ends the program, so a
// test that passes proves that no step of the CPU does.
class SimulatedAccess {
 public:
  SimulatedAccess();
  ~SimulatedAccess();
  SimulatedAccess(const SimulatedAccess&) = delete;
  SimulatedAccess& operator=(const SimulatedAccess&) = delete;
};

}  // namespace gabarit
