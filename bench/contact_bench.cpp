// What the contact check takes on the example motorcycle, stage by stage and as a whole, on one thread and on
// two, and how it grows with the facets (the fitted order at the end).
#include <algorithm>
#include <map>

#include <benchmark/benchmark.h>

#include "bench/motorcycle_mesh.h"
#include "checks/contact_depth.h"
#include "checks/reachable_sides.h"
#include "checks/vertical_cylinder_contact.h"

namespace gabarit {
namespace {

constexpr double radius = 150;
constexpr double sag = 0.1;

const Model& model_of(std::int64_t facets) {
  static std::map<std::int64_t, Model> models;
  auto& model = models[facets];
  if (model.mesh.facets.empty()) model = motorcycle_mesh(static_cast<std::size_t>(facets));
  return model;
}

// What each stage hands to the next.
struct Stages {
  const TriangleMesh& mesh;
  Device device;
  PlanProjection plan{mesh, Frame{}, Interval{}, device};
  ReachGrid grid{plan, radius - sag, radius + sag, sag, device};
  std::vector<PlanSide> sides = reachable_sides(plan, grid);
  OutlineFeatures outline = outline_features(sides);
  DiskPath path = disk_path(outline, radius, device, &grid);
};

Device device_of(const benchmark::State& state) { return Device::cpu(static_cast<int>(state.range(1))); }

void finish(benchmark::State& state) { state.SetComplexityN(state.range(0)); }

template <class Work>
void stage(benchmark::State& state, Work&& work) {
  const Stages stages{model_of(state.range(0)).mesh, device_of(state)};
  for (auto _ : state) benchmark::DoNotOptimize(work(stages));
  finish(state);
}

void projection(benchmark::State& state) {
  stage(state, [](const Stages& s) { return PlanProjection(s.mesh, Frame{}, Interval{}, s.device); });
}
void reach_grid(benchmark::State& state) {
  stage(state, [](const Stages& s) { return ReachGrid(s.plan, radius - sag, radius + sag, sag, s.device); });
}
void outline(benchmark::State& state) {
  stage(state, [](const Stages& s) { return outline_features(reachable_sides(s.plan, s.grid)); });
}
void path_of_one_radius(benchmark::State& state) {
  stage(state, [](const Stages& s) { return disk_path(s.outline, radius, s.device, &s.grid); });
}
void depth_of_one_radius(benchmark::State& state) {
  stage(state, [](const Stages& s) { return ContactDepth(s.sides, radius, s.device).along(s.path, sag); });
}
void contact(benchmark::State& state) {
  const Scene scene(model_of(state.range(0)), device_of(state));
  std::size_t touched = 0;
  for (auto _ : state) {
    const Region region = vertical_cylinder_contact(scene, Setup{}, VerticalCylinder{});
    touched = static_cast<std::size_t>(std::count_if(region.facets.begin(), region.facets.end(),
                                                     [](Selected s) { return s != Selected::no; }));
  }
  state.counters["touched"] = static_cast<double>(touched);
  finish(state);
}

void sizes(benchmark::internal::Benchmark* bench) {
  for (const int threads : {1, 2}) {
    for (const int facets : {440'000, 2'700'000, 12'000'000}) bench->Args({facets, threads});
  }
  bench->ArgNames({"facets", "threads"})
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
}

BENCHMARK(projection)->Apply(sizes);
BENCHMARK(reach_grid)->Apply(sizes);
BENCHMARK(outline)->Apply(sizes);
BENCHMARK(path_of_one_radius)->Apply(sizes);
BENCHMARK(depth_of_one_radius)->Apply(sizes);
BENCHMARK(contact)->Apply(sizes)->Complexity(benchmark::oN);

}  // namespace
}  // namespace gabarit
