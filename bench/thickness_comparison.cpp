#include "bench/thickness_comparison.h"

#include <cmath>

#include "bench/facet_surface.h"
#include "tests/shrinking_sphere.h"

namespace gabarit {

ThicknessComparison compare_thickness(const TriangleMesh& mesh, std::size_t samples) {
  FacetSurface surface = facet_surface(mesh);
  const ShrinkingSphere paper(surface.points, surface.primitives);
  ThicknessComparison row;
  row.facets = surface.primitives.size();
  const auto count = static_cast<double>(row.facets);
  const double start = processor_seconds();
  const Bvh tree(Device::cpu(1), std::move(surface));
  row.build = processor_seconds() - start;
  row.bytes = static_cast<double>(tree.bytes()) / count;
  const std::vector<SphereQuery> queries = inward_queries(mesh, tree);
  std::vector<SphereContact> found(queries.size());
  SphereOptions options = paper_definition(mesh);
  options.greatest_radius = 1;
  row.capped = 1e6 / count * least_seconds_of([&] { maximal_spheres(tree, options, queries, found); });
  options = paper_definition(mesh);
  row.ours = 1e6 / count * least_seconds_of([&] { maximal_spheres(tree, options, queries, found); });

  const std::size_t stride = std::max<std::size_t>(1, queries.size() / samples);
  const auto part = static_cast<double>((queries.size() + stride - 1) / stride);
  row.paper = 1e6 / part * seconds_of([&] {
                for (std::size_t i = 0; i < queries.size(); i += stride) {
                  const SphereQuery& q = queries[i];
                  const ShrunkSphere ball = paper.shrink(q.point, q.direction, q.own);
                  row.rounds += ball.iterations / part;
                  row.greatest_difference =
                      std::max(row.greatest_difference, std::fabs(ball.radius - found[i].radius));
                }
              });
  row.bisection = 1e6 / part * seconds_of([&] {
                    for (std::size_t i = 0; i < queries.size(); i += stride) {
                      const SphereQuery& q = queries[i];
                      row.rounds_of_bisection += paper.bisect(q.point, q.direction, q.own).iterations / part;
                    }
                  });
  return row;
}

}  // namespace gabarit
