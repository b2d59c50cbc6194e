// What the radius of a whole model and of a small region takes, on one thread and on two.
#include <benchmark/benchmark.h>

#include "checks/sphere_placement.h"
#include "checks/turning.h"
#include "tests/shapes.h"

namespace gabarit {
namespace {

// A closed surface of 500 000 facets, curved everywhere: no facet is cheap for being flat.
const Model& ring() {
  static const Model model = shapes::model(shapes::torus(400, 100, 1250, 200));
  return model;
}

void set_up(benchmark::State& state) {
  state.counters["facets"] = static_cast<double>(ring().mesh.facet_count());
}

void turning_of_the_whole(benchmark::State& state) {
  for (auto _ : state) {
    const Scene scene(ring(), Device::cpu(static_cast<int>(state.range(0))));  // its adjacency counts too
    benchmark::DoNotOptimize(measure_turning(scene, Setup{}, whole_model(ring().mesh)));
  }
  set_up(state);
}

void sphere_placement_of_the_whole(benchmark::State& state) {
  for (auto _ : state) {
    const Scene scene(ring(), Device::cpu(static_cast<int>(state.range(0))));
    benchmark::DoNotOptimize(measure_sphere_placement(scene, Setup{}, whole_model(ring().mesh)));
  }
  set_up(state);
}

void turning_of_2000_facets(benchmark::State& state) {
  Region region;
  region.facets.assign(ring().mesh.facet_count(), Selected::no);
  for (std::size_t i = 0; i < 2000; ++i) region.facets[13 * i] = Selected::yes;
  const Scene scene(ring(), Device::cpu(static_cast<int>(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(measure_turning(scene, Setup{}, region));
  set_up(state);
}

BENCHMARK(turning_of_the_whole)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(sphere_placement_of_the_whole)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(turning_of_2000_facets)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace gabarit
