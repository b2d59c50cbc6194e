// Where kernels run: chosen at run time, passed as a value.
#pragma once

namespace gabarit {

// The vector instructions that a CPU runs kernels with; `best` is the widest that it has.
enum class VectorSet { portable, avx2, avx512, best };

class MemoryLimit;

struct Device {
  enum class Kind {
    cpu,
    cuda,
    simulated,  // CPU threads that go the ways of CUDA, with memory apart: all but the chip can be tested
  };
  Kind kind = Kind::cpu;
  int threads = 0;  // CPU threads; 0 means all cores
  int index = 0;    // which CUDA device
  VectorSet vectors = VectorSet::best;
  MemoryLimit* limit = nullptr;  // on memory apart; none when null

  static Device cpu(int threads = 0) { return {.threads = threads}; }
  // `threads`: for what the CPU does beside it.
  static Device cuda(int index = 0, int threads = 0) {
    return {.kind = Kind::cuda, .threads = threads, .index = index};
  }
  static Device simulated(int threads = 0, MemoryLimit* limit = nullptr) {
    return {.kind = Kind::simulated, .threads = threads, .limit = limit};
  }

  // What kernels look at has to be copied there.
  bool has_own_memory() const { return kind != Kind::cpu; }
  // The CPU beside it.
  Device host() const { return {.threads = threads, .vectors = vectors}; }
};

// What `wanted` comes to on this machine: never more than it has.
VectorSet available(VectorSet wanted);

}  // namespace gabarit
