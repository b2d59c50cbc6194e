// Thickness by one search against the paper's shrinking sphere and against bisection, on the same points in
// the same run, one thread: a table like the paper's Table 1 and the course of its Fig. 12. Processor time,
// the least of three runs for ours; the slow methods run on every so many-th point. Usage: bench_thickness
// [GREATEST_FACETS]
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>

#include <fmt/format.h>

#include "gpu/maximal_sphere.h"
#include "tests/block_solid.h"
#include "tests/shapes.h"
#include "tests/shrinking_sphere.h"

namespace gabarit {
namespace {

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
double seconds(Work&& work) {
  const double start = processor_seconds();
  work();
  return processor_seconds() - start;
}

Surface surface_of(const TriangleMesh& mesh) {
  Surface surface;
  surface.points = mesh.vertices;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const Vec3d n = facet_normal(mesh, f);
    if (n == Vec3d{}) continue;
    surface.primitives.push_back(
        {mesh.facets[f], f, {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)}, 0});
  }
  return surface;
}

struct Row {
  double ours = 0, paper = 0, bisection = 0;  // microseconds a query
  double rounds = 0, rounds_of_bisection = 0, build = 0, bytes = 0, greatest_difference = 0;
};

// The paper's definition: every facet counts.
Row compare(const TriangleMesh& mesh, std::size_t samples) {
  const Surface surface = surface_of(mesh);
  const ShrinkingSphere paper(surface.points, surface.primitives);
  Row row;
  const auto count = static_cast<double>(surface.primitives.size());
  Surface copy = surface;
  const double start = processor_seconds();
  const Bvh tree(Device::cpu(1), std::move(copy));
  row.build = processor_seconds() - start;
  row.bytes = static_cast<double>(tree.bytes()) / count;
  std::vector<SphereQuery> queries;
  for (const std::uint32_t f : tree.order())
    queries.push_back({mesh.centroid(f), -facet_normal(mesh, f), f, 0, 0, 0});
  std::vector<SphereContact> found(queries.size());
  const SphereOptions options{.cos_separation = 1,
                              .contact_floor = 1e-6 * length(bounding_box(mesh).extent())};
  row.ours = 1e300;
  for (int run = 0; run < 3; ++run)
    row.ours =
        std::min(row.ours, 1e6 / count * seconds([&] { maximal_spheres(tree, options, queries, found); }));
  const std::size_t stride = std::max<std::size_t>(1, queries.size() / samples);
  const double part = static_cast<double>((queries.size() + stride - 1) / stride);
  row.paper = 1e6 / part * seconds([&] {
                for (std::size_t i = 0; i < queries.size(); i += stride) {
                  const ShrunkSphere ball =
                      paper.shrink(queries[i].point, queries[i].direction, queries[i].own);
                  row.rounds += ball.iterations / part;
                  row.greatest_difference =
                      std::max(row.greatest_difference, std::fabs(ball.radius - found[i].radius));
                }
              });
  row.bisection =
      1e6 / part * seconds([&] {
        for (std::size_t i = 0; i < queries.size(); i += stride)
          row.rounds_of_bisection +=
              paper.bisect(queries[i].point, queries[i].direction, queries[i].own).iterations / part;
      });
  return row;
}

void print(const char* name, const TriangleMesh& mesh, std::size_t samples) {
  const Row row = compare(mesh, samples);
  const Vec3d e = bounding_box(mesh).extent();
  fmt::print(
      "| {} | {} | {:.0f} x {:.0f} x {:.0f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} | {:.2f} | "
      "{:.1f} | {:.1e} |\n",
      name, mesh.facet_count(), e.x, e.y, e.z, row.rounds, row.rounds_of_bisection, row.paper, row.bisection,
      row.ours, row.paper / row.ours, row.build, row.bytes, row.greatest_difference);
  std::fflush(stdout);
}

int squares(double facets, double ratio) { return static_cast<int>(std::sqrt(facets * ratio)); }

void run(double most) {
  fmt::print(
      "| part | facets | size, mm | rounds | of bisection | paper, µs | bisection, µs | ours, µs | ratio | "
      "build, s | bytes a facet | difference, mm |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const double facets : {2e4, 2e5, 2e6}) {
    if (facets > most) continue;
    const std::size_t samples = facets > 1e6 ? 2000 : 20000;
    print("ribbed casting (thin)", shapes::with_facets(shapes::ribbed_casting(), facets), samples);
    print("cup with a handle", shapes::with_facets(shapes::cup_with_a_handle(), facets), samples);
    print("block with holes (thick)", shapes::with_facets(shapes::thick_block_with_holes(), facets),
          samples / 10);
    print("ball", shapes::mesh(shapes::sphere(50, squares(facets, 0.25), squares(facets, 1))), samples / 400);
    print("torus", shapes::mesh(shapes::torus(50, 12, squares(facets, 1), squares(facets, 0.25))),
          samples / 100);
  }
}

}  // namespace
}  // namespace gabarit

int main(int argc, char** argv) {
  gabarit::run(argc > 1 ? std::atof(argv[1]) : 2e6);
  return 0;
}
