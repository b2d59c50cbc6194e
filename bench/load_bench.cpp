// Reading a binary STL file of 2.7 million facets (135 MB), stage by stage. The file's bytes are in memory,
// as they are when the system has cached the file.
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

#include <benchmark/benchmark.h>

#include "model/defects.h"
#include "model/load_stl.h"
#include "model/sha256.h"

namespace gabarit {
namespace {

// A bumpy sphere: every vertex is shared by six facets, as on scans and tessellated surfaces.
std::string bumpy_sphere(int steps) {
  const auto point = [&](int i, int j) {
    const double a = 2 * std::numbers::pi * (i % steps) / steps;
    const double b = std::numbers::pi * (j + 0.5) / (steps + 1) - std::numbers::pi / 2;
    const double r = 800 + 40 * std::sin(7 * a) * std::cos(5 * b);
    return Vec3f{static_cast<float>(r * std::cos(b) * std::cos(a)),
                 static_cast<float>(r * std::cos(b) * std::sin(a)), static_cast<float>(r * std::sin(b))};
  };
  std::string bytes(84, ' ');
  std::uint32_t facets = 0;
  const auto add = [&](const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    std::array<char, 50> facet{};
    std::memcpy(facet.data() + 12, &a, 12);
    std::memcpy(facet.data() + 24, &b, 12);
    std::memcpy(facet.data() + 36, &c, 12);
    bytes.append(facet.data(), facet.size());
    ++facets;
  };
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      add(point(i, j), point(i + 1, j), point(i + 1, j + 1));
      add(point(i, j), point(i + 1, j + 1), point(i, j + 1));
    }
  }
  std::memcpy(bytes.data() + 80, &facets, sizeof facets);
  return bytes;
}

const std::string& file() {
  static const std::string bytes = bumpy_sphere(1164);
  return bytes;
}

Model loaded() {
  Model model;
  if (!load_binary_stl(file(), "bench", 1.0, model).empty()) std::abort();
  return model;
}

void read_and_weld(benchmark::State& state) {
  file();
  for (auto _ : state) benchmark::DoNotOptimize(loaded());
  state.counters["facets"] = static_cast<double>((file().size() - 84) / 50);
}
BENCHMARK(read_and_weld)->Unit(benchmark::kMillisecond);

void hash(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(sha256(file()));
}
BENCHMARK(hash)->Unit(benchmark::kMillisecond);

void defects(benchmark::State& state) {
  const Model model = loaded();
  for (auto _ : state) benchmark::DoNotOptimize(count_defects(model.mesh));
}
BENCHMARK(defects)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gabarit
