// The dexel method beside the paper's Table 1 (on a mesh of the same size and as many lines; the paper's
// models are not public), what its schedule costs, and how often dexels and the exact method disagree.
#include <array>
#include <map>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "bench/motorcycle_mesh.h"
#include "bench/paper_dexels.h"
#include "checks/vertical_cylinder_contact.h"

namespace gabarit {
namespace {

constexpr double radius = 150;

struct Row {
  const char* model;
  std::int64_t facets, columns, rows;
  double seconds;
};

// Table 1: Core i7 at 2.6 GHz and GeForce GTX 960M; both steps of the inspection.
constexpr std::array table{Row{"A", 437'040, 2054, 1018, 24.75}, Row{"D", 429'454, 2128, 944, 26.87},
                           Row{"C", 673'958, 2071, 1001, 30.10}, Row{"B", 2'700'707, 2055, 1017, 63.02}};

const Model& model_of(std::int64_t facets) {
  static std::map<std::int64_t, Model> models;
  Model& model = models[facets];
  if (model.mesh.facets.empty()) model = motorcycle_mesh(static_cast<std::size_t>(facets));
  return model;
}

// As many lines across the length as the paper has.
double spacing_for(const Model& model, std::int64_t columns) {
  return (model.box.max.x - model.box.min.x + 2 * radius) / static_cast<double>(columns);
}

Region contact(const Model& model, ContactMethod method, double spacing, int threads = 1) {
  return vertical_cylinder_contact(Scene(model, Device::cpu(threads)), Setup{},
                                   {.radius = radius, .method = method, .spacing = spacing});
}

void table_1(benchmark::State& state) {
  const Row& row = table[static_cast<std::size_t>(state.range(0))];
  const auto method = state.range(1) == 0 ? ContactMethod::exact : ContactMethod::dexel;
  const Model& model = model_of(row.facets);
  const double spacing = spacing_for(model, row.columns);
  for (auto _ : state) benchmark::DoNotOptimize(contact(model, method, spacing));
  state.counters["paper_s"] = row.seconds;
  state.counters["facets"] = static_cast<double>(model.mesh.facet_count());
  const double across = (model.box.max.y - model.box.min.y + 2 * radius) / spacing;
  state.SetLabel(method == ContactMethod::exact
                     ? fmt::format("{}: exact", row.model)
                     : fmt::format("{}: {} x {:.0f} lines of dexels (paper: {} x {})", row.model, row.columns,
                                   across, row.columns, row.rows));
}
BENCHMARK(table_1)->ArgNames({"row", "dexel"})->ArgsProduct({{0, 1, 2, 3}, {0, 1}})->Unit(benchmark::kSecond);

// Everything that the paper places disks and rectangles on: every corner and every side once.
struct Features {
  std::vector<Point2> points;
  std::vector<PlanEdge> edges;
  DexelLines lines;
};

Features features_of(const Model& model) {
  Features out;
  const TriangleMesh& mesh = model.mesh;
  for (const Vec3d& p : mesh.vertices) out.points.push_back({p.x, p.y});
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId a = mesh.facets[f][i];
      const VertexId b = mesh.facets[f][(i + 1) % 3];
      if (a < b && !(out.points[a] == out.points[b])) out.edges.push_back({out.points[a], out.points[b]});
    }
  }
  constexpr double spacing = 0.98;
  const double first = model.box.min.y - radius - spacing;
  out.lines = {first, spacing, static_cast<std::int64_t>((model.box.max.y + radius - first) / spacing) + 2};
  return out;
}

// One direction of lines, the same dexels either way. The rounds are tried on one thread only: more of them
// wait for each other at the end of every round.
void offset(benchmark::State& state) {
  const Features features = features_of(model_of(state.range(0)));
  const Device device = Device::cpu(static_cast<int>(state.range(2)));
  std::int64_t rounds = 1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        state.range(1) == 0
            ? offset_dexels(device, features.points, features.edges, features.lines, radius)
            : paper::offset_dexels(device, features.points, features.edges, features.lines, radius, rounds));
  }
  state.counters["rounds"] = static_cast<double>(rounds);
  state.SetLabel(state.range(1) == 0 ? "lines on their own" : "the paper's rounds");
}
BENCHMARK(offset)
    ->ArgNames({"facets", "rounds", "threads"})
    ->Args({437'040, 1, 1})
    ->Args({437'040, 0, 1})
    ->Args({437'040, 0, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

// Shares of the facets that the exact method finds touched. `nominal` compares depths at the true radius
// alone, as the paper does; `maybe` is what the method leaves open; `wrong` what it decides otherwise.
void disagreement(benchmark::State& state) {
  const Model& model = model_of(437'040);
  const double spacing = static_cast<double>(state.range(0)) / 100;
  const Region exact = contact(model, ContactMethod::exact, 0);
  Region dexel;
  for (auto _ : state) dexel = contact(model, ContactMethod::dexel, spacing);
  double touched = 0, missed = 0, added = 0, maybe = 0, wrong = 0;
  const auto near = [](const Region& region, FacetId f) { return region.depth[f] <= 0.1F; };
  for (FacetId f = 0; f < model.mesh.facet_count(); ++f) {
    touched += near(exact, f) ? 1 : 0;
    missed += near(exact, f) && !near(dexel, f) ? 1 : 0;
    added += !near(exact, f) && near(dexel, f) ? 1 : 0;
    maybe += dexel.facets[f] == Selected::maybe ? 1 : 0;
    wrong += dexel.facets[f] != Selected::maybe && dexel.facets[f] != exact.facets[f] ? 1 : 0;
  }
  state.counters["spacing_mm"] = spacing;
  state.counters["touched"] = touched;
  state.counters["nominal_missed_%"] = 100 * missed / touched;
  state.counters["nominal_added_%"] = 100 * added / touched;
  state.counters["maybe_%"] = 100 * maybe / touched;
  state.counters["wrong"] = wrong;
}
BENCHMARK(disagreement)
    ->ArgName("hundredths_of_mm")
    ->Arg(10)
    ->Arg(25)
    ->Arg(50)
    ->Arg(98)
    ->Arg(200)
    ->Arg(400)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gabarit
