// One view at 1600 x 1000 pixels of a bumpy ball with 2.7 million facets, as many as a detailed motorcycle
// has.
#include <cmath>

#include <benchmark/benchmark.h>

#include "report/palette.h"
#include "report/render.h"

namespace gabarit {
namespace {

// `rings` bands of quads around z, each split into two facets.
TriangleMesh bumpy_ball(int rings) {
  constexpr double pi = 3.14159265358979323846;
  const int segments = 2 * rings;
  TriangleMesh mesh;
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j < segments; ++j) {
      const double theta = pi * (i + 0.5) / (rings + 1);
      const double phi = 2 * pi * j / segments;
      const double r = 600 + 60 * std::sin(9 * theta) * std::cos(8 * phi);
      mesh.vertices.push_back({1.7 * r * std::sin(theta) * std::cos(phi), r * std::sin(theta) * std::sin(phi),
                               r * std::cos(theta)});
    }
  }
  const auto at = [&](int i, int j) { return static_cast<VertexId>(i * segments + j % segments); };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < segments; ++j) {
      mesh.facets.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.facets.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

const TriangleMesh& motorcycle_sized() {
  static const TriangleMesh mesh = bumpy_ball(822);
  return mesh;
}

void show(benchmark::State& state, const Drawing& drawing, const Camera& camera) {
  const Device device = Device::cpu(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(render(drawing, camera, 1600, 1000, device));
  state.counters["facets"] = static_cast<double>(drawing.mesh->facet_count());
}

void whole_model(benchmark::State& state) {
  Drawing drawing;
  drawing.mesh = &motorcycle_sized();
  show(state, drawing, fixed_views(bounding_box(*drawing.mesh), {}, 1.6).back().camera);
}

// Every fifth facet fails: the worst case of what must stay visible.
void whole_model_with_marks(benchmark::State& state) {
  Drawing drawing;
  drawing.mesh = &motorcycle_sized();
  std::vector<Rgb> colours(drawing.mesh->facet_count(), palette::out_of_reach);
  std::vector<std::uint8_t> marked(colours.size());
  for (std::size_t f = 0; f < colours.size(); f += 5) colours[f] = palette::fail, marked[f] = 2;
  drawing.facet_colours = colours;
  drawing.marked = marked;
  show(state, drawing, fixed_views(bounding_box(*drawing.mesh), {}, 1.6).back().camera);
}

void close_up_of_40_mm(benchmark::State& state) {
  Drawing drawing;
  drawing.mesh = &motorcycle_sized();
  show(state, drawing,
       close_up(drawing.mesh->centroid(700000), facet_normal(*drawing.mesh, 700000), {}, 40, 1.6));
}

BENCHMARK(whole_model)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK(whole_model_with_marks)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK(close_up_of_40_mm)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gabarit
