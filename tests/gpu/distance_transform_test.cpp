#include "gpu/distance_transform.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace gabarit {
namespace {

std::vector<float> transform(const CellGrid& grid, const std::vector<std::uint8_t>& marked,
                             Device device = Device::cpu(1)) {
  std::vector<float> distance(marked.size());
  distance_transform(device, grid, marked, distance);
  return distance;
}

CellGrid grid_of(std::int64_t columns, std::int64_t rows, double size = 1) {
  return {{0, 0}, size, columns, rows};
}

TEST(DistanceTransform, one_marked_cell_is_as_far_as_pythagoras_says) {
  std::vector<std::uint8_t> marked(7 * 5, 0);
  marked[1 * 7 + 2] = 1;
  const auto distance = transform(grid_of(7, 5, 2), marked);
  EXPECT_EQ(distance[1 * 7 + 2], 0);
  EXPECT_EQ(distance[4 * 7 + 6], 10);  // 4 and 3 cells of 2 mm
}

TEST(DistanceTransform, nothing_marked_is_infinitely_far) {
  for (const float d : transform(grid_of(9, 4), std::vector<std::uint8_t>(36, 0)))
    EXPECT_EQ(d, std::numeric_limits<float>::infinity());
}

// The nearest of all marked cells, one by one.
float nearest(const CellGrid& grid, const std::vector<std::uint8_t>& marked, std::int64_t x, std::int64_t y) {
  auto least = std::numeric_limits<std::int64_t>::max();
  for (std::int64_t v = 0; v < grid.rows; ++v) {
    for (std::int64_t u = 0; u < grid.columns; ++u) {
      if (marked[static_cast<std::size_t>(v * grid.columns + u)] != 0)
        least = std::min(least, (u - x) * (u - x) + (v - y) * (v - y));
    }
  }
  return std::sqrt(static_cast<float>(least)) * static_cast<float>(grid.size);
}

TEST(DistanceTransform, random_marks_are_as_far_as_the_nearest_of_all) {
  std::mt19937 random(7);
  for (const unsigned one_in : {2U, 20U, 500U}) {
    const CellGrid grid = grid_of(83, 61, 0.7);
    std::vector<std::uint8_t> marked(83 * 61, 0);
    marked[random() % marked.size()] = 1;
    for (auto& m : marked) {
      if (random() % one_in == 0) m = 1;
    }
    const auto distance = transform(grid, marked);
    for (std::int64_t y = 0; y < grid.rows; ++y) {
      for (std::int64_t x = 0; x < grid.columns; ++x)
        ASSERT_EQ(distance[static_cast<std::size_t>(y * grid.columns + x)], nearest(grid, marked, x, y));
    }
  }
}

TEST(DistanceTransform, threads_and_vector_instructions_give_the_same_bits) {
  std::mt19937 random(8);
  const CellGrid grid = grid_of(700, 300, 1.3);
  std::vector<std::uint8_t> marked(700 * 300, 0);
  for (auto& m : marked) m = random() % 300 == 0 ? 1 : 0;
  const auto one = transform(grid, marked, {Device::Kind::cpu, 1, 0, VectorSet::portable});
  EXPECT_EQ(one, transform(grid, marked, Device::cpu(4)));
  EXPECT_EQ(one, transform(grid, marked, {Device::Kind::cpu, 2, 0, VectorSet::avx2}));
}

}  // namespace
}  // namespace gabarit
