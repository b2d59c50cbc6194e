#include "gpu/outline_cells.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Facets {
  std::vector<Vec3d> points;
  std::vector<std::array<std::uint32_t, 3>> facets;

  PlanFacets plan(double from, double to, const Device& device = Device::cpu(2)) const {
    return {device, points, facets, {}, from, to};
  }
};

// Of all sizes, from a fraction of a cell to half the grid.
Facets random_facets() {
  Facets out;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(10, 90), offset(-1, 1);
  for (std::uint32_t i = 0; i < 200; ++i) {
    const Vec3d a{anywhere(random), anywhere(random), anywhere(random)};
    const double size = i % 2 == 0 ? 0.4 : 9;
    for (int k = 0; k < 3; ++k)
      out.points.push_back(a + Vec3d{offset(random), offset(random), offset(random)} * size);
    out.facets.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return out;
}

const CellGrid grid{{0, 0}, 1, 100, 100};

// Every side in tiny steps.
template <class Use>
void for_each_place(const PlanPolygon& polygon, Use&& use) {
  for (int i = 0; i < polygon.size; ++i) {
    for (int k = 0; k <= 200; ++k)
      use(polygon.corner[i] + (polygon.next(i) - polygon.corner[i]) * (k / 200.0));
  }
}

Point2 middle(std::int64_t cell) {
  return {static_cast<double>(cell % grid.columns) + 0.5, static_cast<double>(cell / grid.columns) + 0.5};
}

std::vector<std::uint8_t> marked(const PlanFacets& plan) {
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(grid.count()), 0);
  OutlineCells(plan, grid).mark(cells);
  return cells;
}

class Band : public testing::TestWithParam<std::pair<double, double>> {
 protected:
  const Facets all = random_facets();
  const PlanFacets plan = all.plan(GetParam().first, GetParam().second);
  const PlanMesh mesh = plan.mesh();
};

TEST_P(Band, every_place_of_an_outline_lies_in_or_beside_a_marked_cell) {
  const auto cells = marked(plan);
  for (std::int64_t f = 0; f < mesh.facets.size; ++f) {
    for_each_place(mesh.polygon(f), [&](Point2 p) {
      const std::int64_t at = grid.cell(p);
      double least = infinity;
      for (const std::int64_t c : {at, at - 1, at + 1, at - grid.columns, at + grid.columns}) {
        if (cells[static_cast<std::size_t>(c)] != 0) least = std::min(least, length(p - middle(c)));
      }
      ASSERT_LE(least, std::sqrt(0.5) + 0.5);
    });
  }
}

TEST_P(Band, no_cell_is_marked_that_no_outline_passes_through) {
  auto cells = marked(plan);
  for (std::int64_t f = 0; f < mesh.facets.size; ++f) {
    for_each_place(mesh.polygon(f), [&](Point2 p) {
      for (const double x : {-0.1, 0.0, 0.1}) {
        for (const double y : {-0.1, 0.0, 0.1})
          cells[static_cast<std::size_t>(grid.cell(p + Point2{x, y}))] = 0;
      }
    });
  }
  EXPECT_EQ(cells, std::vector<std::uint8_t>(cells.size(), 0));
}

TEST_P(Band, a_facet_is_near_when_a_place_of_its_outline_lies_in_a_near_cell) {
  std::vector<float> distance;
  for (std::int64_t c = 0; c < grid.count(); ++c)
    distance.push_back(static_cast<float>(length(middle(c) - Point2{50, 50})));
  std::vector<std::uint8_t> near(static_cast<std::size_t>(mesh.facets.size));
  constexpr double most = 20;
  OutlineCells(plan, grid).near(distance, most, near);
  for (std::int64_t f = 0; f < mesh.facets.size; ++f) {
    double least = infinity;
    for_each_place(mesh.polygon(f), [&](Point2 p) {
      least = std::min<double>(least, distance[static_cast<std::size_t>(grid.cell(p))]);
    });
    // Samples are a cell apart: what lies between them may be told either way.
    const bool told = near[static_cast<std::size_t>(f)] != 0;
    EXPECT_TRUE(told || least > most - 1.5) << f;
    EXPECT_FALSE(told && least > most) << f;
  }
}

TEST_P(Band, threads_make_no_difference) {
  for (const Device& device : {Device::cpu(1), Device::cpu(4), Device::simulated(2)})
    EXPECT_EQ(marked(plan), marked(all.plan(GetParam().first, GetParam().second, device)));
}

INSTANTIATE_TEST_SUITE_P(OutlineCells, Band,
                         testing::Values(std::pair(-infinity, infinity), std::pair(30.0, 60.0)));

}  // namespace
}  // namespace gabarit
