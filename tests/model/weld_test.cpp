#include "model/weld.h"

#include <limits>
#include <random>

#include <gmock/gmock.h>

namespace gabarit {
namespace {

using testing::ElementsAre;

std::vector<VertexId> weld(const std::vector<Vec3d>& points, std::vector<Vec3d>& vertices,
                           std::size_t expected = 0) {
  std::vector<VertexId> numbers(points.size());
  VertexWeld(vertices, expected).add(points, numbers.data());
  return numbers;
}

TEST(weld, equal_points_get_one_number_in_the_order_of_appearance) {
  std::vector<Vec3d> vertices;
  EXPECT_THAT(weld({{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {3, 2, 1}, {0, 0, 0}}, vertices),
              ElementsAre(0, 1, 0, 2, 1));
  EXPECT_EQ(vertices, (std::vector<Vec3d>{{1, 2, 3}, {0, 0, 0}, {3, 2, 1}}));
}

TEST(weld, minus_zero_is_zero_and_the_next_double_is_another_point) {
  std::vector<Vec3d> vertices;
  EXPECT_THAT(weld({{0, 0, 0}, {-0.0, 0, -0.0}, {std::nextafter(0.0, 1.0), 0, 0}}, vertices),
              ElementsAre(0, 0, 1));
}

TEST(weld, points_that_are_not_finite_are_never_equal) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Vec3d> vertices;
  EXPECT_THAT(weld({{nan, 0, 0}, {nan, 0, 0}, {infinity, 0, 0}, {infinity, 0, 0}, {1, 0, 0}}, vertices),
              ElementsAre(0, 1, 2, 3, 4));
}

TEST(weld, agrees_with_a_search_through_all_points_however_many_were_expected) {
  std::mt19937 random(5);
  std::vector<Vec3d> points;
  for (int i = 0; i < 5000; ++i)
    points.push_back({static_cast<double>(random() % 12), static_cast<double>(random() % 12) / 8,
                      -static_cast<double>(random() % 12)});
  for (const std::size_t expected : {0, 10, 100'000}) {
    std::vector<Vec3d> vertices;
    const std::vector<VertexId> numbers = weld(points, vertices, expected);
    std::vector<Vec3d> known;
    for (std::size_t i = 0; i < points.size(); ++i) {
      auto place = std::find(known.begin(), known.end(), points[i]);
      if (place == known.end()) place = known.insert(known.end(), points[i]);
      ASSERT_EQ(numbers[i], place - known.begin());
    }
    EXPECT_EQ(vertices, known);
  }
}

TEST(weld, goes_on_from_one_batch_to_the_next) {
  std::vector<Vec3d> vertices;
  VertexWeld weld(vertices);
  std::vector<VertexId> numbers(3000);
  std::vector<Vec3d> points;
  for (int i = 0; i < 3000; ++i) points.push_back({static_cast<double>(i), 0, 0});
  weld.add(points, numbers.data());
  weld.add(points, numbers.data());
  EXPECT_EQ(vertices.size(), 3000U);
  EXPECT_EQ(numbers.back(), 2999U);
}

}  // namespace
}  // namespace gabarit
