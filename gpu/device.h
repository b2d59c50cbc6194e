// Where kernels run: chosen at run time, passed as a value.
#pragma once

namespace gabarit {

struct Device {
  enum class Kind { cpu, cuda };
  Kind kind = Kind::cpu;
  int threads = 0;  // CPU threads; 0 means all cores
  int index = 0;    // which CUDA device

  static Device cpu(int threads = 0) { return {Kind::cpu, threads, 0}; }
};

}  // namespace gabarit
