// Thickness by one search against the paper's shrinking sphere and bisection, and the whole measure on shapes
// where everything is equally far away. Processor time of one thread.
// Usage: bench_thickness [--most FACETS] [--chart FILE.svg] [--only ratios|table|figure|far]
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include <fmt/format.h>

#include "bench/facet_surface.h"
#include "bench/thickness_chart.h"
#include "bench/thickness_comparison.h"
#include "checks/scene.h"
#include "checks/wall_measure.h"
#include "rules/read_value.h"
#include "tests/block_solid.h"
#include "tests/shapes.h"

namespace gabarit {
namespace {

TriangleMesh part(shapes::BlockSolid (*solid)(), double facets) {
  return shapes::with_facets(solid(), facets);
}
int squares(double facets, double ratio) { return static_cast<int>(std::sqrt(facets * ratio)); }
TriangleMesh ball(double facets) {
  return shapes::mesh(shapes::sphere(50, squares(facets, 0.25), squares(facets, 1)));
}
TriangleMesh ring(double facets) {
  return shapes::mesh(shapes::torus(50, 12, squares(facets, 1), squares(facets, 0.25)));
}

std::string size_text(const TriangleMesh& mesh) {
  const Vec3d e = bounding_box(mesh).extent();
  return fmt::format("{:.0f} x {:.0f} x {:.0f}", e.x, e.y, e.z);
}

void print_row(const char* name, const TriangleMesh& mesh, std::size_t samples) {
  const ThicknessComparison row = compare_thickness(mesh, samples);
  fmt::print(
      "| {} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} | {:.2f} | {:.1f} | "
      "{:.1e} "
      "|\n",
      name, row.facets, size_text(mesh), row.rounds, row.rounds_of_bisection, row.paper, row.bisection,
      row.ours, row.capped, row.ratio(), row.build, row.bytes, row.greatest_difference);
  std::fflush(stdout);
}

void print_ratios(double most) {
  fmt::print(
      "\nMicroseconds a query; `2 mm`: with a greatest thickness of 2 mm.\n\n"
      "| part | facets | size, mm | rounds | of bisection | paper | bisection | ours | ours, 2 mm | ratio | "
      "build, s | bytes a facet | difference, mm |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const double facets : {2e3, 2e4, 2e5, 2e6}) {
    if (facets > most) continue;
    const std::size_t samples = facets > 1e6 ? 2000 : 20000;
    print_row("ribbed casting (thin)", part(shapes::ribbed_casting, facets), samples);
    print_row("the same with draft", part(shapes::drafted_casting, facets), samples / 2);
    print_row("cup with a handle", part(shapes::cup_with_a_handle, facets), samples);
    print_row("block with holes (thick)", part(shapes::thick_block_with_holes, facets), samples / 10);
    print_row("ball", ball(facets), samples / 400);
    print_row("torus", ring(facets), samples / 100);
  }
}

// Parts as large as the paper's five; whole parts, seconds.
void print_table_1(double most) {
  fmt::print(
      "\n| as large as the paper's | part | facets | size, mm | rounds | paper's method, s | ours, s | ratio "
      "|\n"
      "|---|---|---|---|---|---|---|---|\n");
  const auto row = [&](const char* like, const char* name, shapes::BlockSolid (*solid)(), double facets) {
    if (facets > most * 1.01) return;
    const TriangleMesh mesh = part(solid, facets);
    const ThicknessComparison c = compare_thickness(mesh, 2000);
    const double all = 1e-6 * static_cast<double>(c.facets);
    fmt::print("| {} | {} | {} | {} | {:.2f} | {:.3g} | {:.3g} | {:.0f} |\n", like, name, c.facets,
               size_text(mesh), c.rounds, c.paper * all, c.ours * all, c.ratio());
    std::fflush(stdout);
  };
  row("A", "cup with a handle", shapes::cup_with_a_handle, 17970);
  row("B", "block with holes", shapes::thick_block_with_holes, 197450);
  row("C", "casting with draft", shapes::drafted_casting, 202520);
  row("D", "ribbed casting", shapes::ribbed_casting, 1708000);
  row("E", "casting with draft", shapes::drafted_casting, 1972196);
}

std::vector<ChartLine> print_fig_12(double most) {
  fmt::print(
      "\n| facets | thin, paper's method, s | thin, ours, s | facets | thick, paper's method, s | thick, "
      "ours, s "
      "|\n|---|---|---|---|---|---|\n");
  std::vector<ChartLine> lines{{"thick, paper", "#c0392b", true, {}},
                               {"thin, paper", "#1f618d", true, {}},
                               {"thick, ours", "#c0392b", false, {}},
                               {"thin, ours", "#1f618d", false, {}}};
  for (const double facets : {2e4, 5e4, 1e5, 2e5, 5e5, 1e6, 2e6}) {
    if (facets > most) continue;
    const ThicknessComparison thin = compare_thickness(part(shapes::cup_with_a_handle, facets), 2000);
    const ThicknessComparison thick = compare_thickness(part(shapes::thick_block_with_holes, facets), 400);
    const auto m = static_cast<double>(thin.facets), n = static_cast<double>(thick.facets);
    lines[0].points.emplace_back(n, 1e-6 * n * thick.paper);
    lines[1].points.emplace_back(m, 1e-6 * m * thin.paper);
    lines[2].points.emplace_back(n, 1e-6 * n * thick.ours);
    lines[3].points.emplace_back(m, 1e-6 * m * thin.ours);
    fmt::print("| {} | {:.3g} | {:.3g} | {} | {:.3g} | {:.3g} |\n", thin.facets, 1e-6 * m * thin.paper,
               1e-6 * m * thin.ours, thick.facets, 1e-6 * n * thick.paper, 1e-6 * n * thick.ours);
    std::fflush(stdout);
  }
  return lines;
}

// All of `measure thickness` but files: features, sags, tree, normals, balls with bounds.
double seconds_of_measure(const TriangleMesh& mesh, const char* method) {
  Model model;
  model.mesh = mesh;
  Arguments arguments;
  arguments.set("method", std::string(method));
  fill_defaults(wall_parameters(Side::inside), arguments);
  return seconds_of([&] {
    const Scene scene(model, Device::cpu(1));
    measure_walls(Side::inside, scene, {}, whole_model(mesh), arguments);
  });
}

void print_equally_far(double most) {
  const double facets = std::min(most, 1.3e6);
  fmt::print(
      "\n| part | facets | wall, all of it, µs a facet | sphere, all of it, µs a facet | raw balls, µs a "
      "query "
      "|\n|---|---|---|---|---|\n");
  const auto row = [](const char* name, const TriangleMesh& mesh) {
    const auto all = static_cast<double>(mesh.facet_count());
    fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.2f} |\n", name, mesh.facet_count(),
               1e6 / all * seconds_of_measure(mesh, "wall"), 1e6 / all * seconds_of_measure(mesh, "sphere"),
               compare_thickness(mesh, 10).ours);
    std::fflush(stdout);
  };
  row("ribbed casting", part(shapes::ribbed_casting, facets));
  row("ball", ball(facets));
  row("torus", ring(facets));
}

}  // namespace
}  // namespace gabarit

int main(int argc, char** argv) {
  double most = 2e6;
  const char* chart = nullptr;
  std::string only;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--most") == 0) most = std::atof(argv[i + 1]);
    if (std::strcmp(argv[i], "--chart") == 0) chart = argv[i + 1];
    if (std::strcmp(argv[i], "--only") == 0) only = argv[i + 1];
  }
  const auto wanted = [&](const char* name) { return only.empty() || only == name; };
  if (wanted("ratios")) gabarit::print_ratios(most);
  if (wanted("table")) gabarit::print_table_1(most);
  if (wanted("figure")) {
    const auto lines = gabarit::print_fig_12(most);
    if (chart != nullptr) std::ofstream(chart) << gabarit::thickness_chart(lines);
  }
  if (wanted("far")) gabarit::print_equally_far(most);
  return 0;
}
