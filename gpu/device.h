// Where kernels run: chosen at run time, passed as a value.
#pragma once

namespace gabarit {

// The vector instructions that a CPU runs kernels with; `best` is the widest that it has.
enum class VectorSet { portable, avx2, avx512, best };

struct Device {
  enum class Kind { cpu, cuda };
  Kind kind = Kind::cpu;
  int threads = 0;  // CPU threads; 0 means all cores
  int index = 0;    // which CUDA device
  VectorSet vectors = VectorSet::best;

  static Device cpu(int threads = 0) { return {Kind::cpu, threads, 0, VectorSet::best}; }
  static Device cuda(int index = 0) { return {Kind::cuda, 0, index, VectorSet::best}; }
};

// What `wanted` comes to on this machine: never more than it has.
VectorSet available(VectorSet wanted);

}  // namespace gabarit
