#include "model/edge_overlap.h"

#include <gmock/gmock.h>

#include "tests/shapes.h"

namespace gabarit {
namespace {

using shapes::Triangles;

// Half-edge 0 is the long side of the first facet.
std::vector<EdgeOverlap> overlaps(const Triangles& triangles) {
  const std::vector<HalfEdgeId> asked{0};
  return overlapping_edges(shapes::mesh(triangles), asked, 1e-3);
}

const shapes::Triangle long_side{{{0, 0, 0}, {10, 0, 0}, {5, 5, 0}}};

TEST(edge_overlap, gives_the_shared_part_and_the_direction) {
  const auto found =
      overlaps({long_side, {{{7, 0, 0}, {2, 0, 0}, {5, -5, 0}}}, {{{8, 0, 0}, {12, 0, 0}, {9, -5, 0}}}});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].other, 3U);
  EXPECT_TRUE(found[0].reversed);
  EXPECT_FLOAT_EQ(found[0].from, 0.2F);
  EXPECT_FLOAT_EQ(found[0].to, 0.7F);
  EXPECT_EQ(found[1].other, 6U);
  EXPECT_FALSE(found[1].reversed);
  EXPECT_FLOAT_EQ(found[1].from, 0.8F);
  EXPECT_FLOAT_EQ(found[1].to, 1.0F);
}

TEST(edge_overlap, only_the_shared_part_has_to_lie_on_the_line) {
  // A far longer edge at a slight angle leaves the line beyond the end of the one asked about.
  EXPECT_EQ(overlaps({long_side, {{{10000, 0.5, 0}, {0, 0, 0}, {5, -5, 0}}}}).size(), 1U);
  EXPECT_EQ(overlaps({long_side, {{{10000, 50, 0}, {0, 0, 0}, {5, -5, 0}}}}).size(), 0U);
}

TEST(edge_overlap, nothing_asked_nothing_found) {
  EXPECT_TRUE(overlapping_edges(shapes::mesh({long_side}), {}, 1e-3).empty());
}

TEST(edge_overlap, edges_far_longer_than_the_ones_asked_about_are_no_trouble) {
  const auto with_length = [](double size) {
    return overlaps({long_side, {{{size, 0, 0}, {-size, 0, 0}, {5, -size, 0}}}});
  };
  for (const double size : {1e6, 1e12}) {
    ASSERT_EQ(with_length(size).size(), 1U) << size;
    EXPECT_FLOAT_EQ(with_length(size)[0].from, 0);
    EXPECT_FLOAT_EQ(with_length(size)[0].to, 1);
  }
  // Here doubles do not tell any more where the line is; that an answer comes is all that can be asked.
  for (const double size : {1e30, 1e100}) EXPECT_LE(with_length(size).size(), 1U) << size;
}

}  // namespace
}  // namespace gabarit
