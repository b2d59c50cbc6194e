#include "gpu/batches.h"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

struct Part {
  std::int64_t begin, end;
  friend bool operator==(Part, Part) = default;
};

// What is left when runs longer than `most` do not fit.
std::vector<Part> runs_that_fit(std::int64_t n, std::int64_t unit, std::int64_t most) {
  std::vector<Part> runs;
  in_batches(n, unit, [&](std::int64_t begin, std::int64_t end) {
    if (end - begin > most) throw OutOfDeviceMemory("full");
    runs.push_back({begin, end});
  });
  return runs;
}

TEST(Batches, what_fits_goes_in_one) {
  EXPECT_EQ(runs_that_fit(1000, 32, 1000), (std::vector<Part>{{0, 1000}}));
}

TEST(Batches, nothing_asks_for_nothing) { EXPECT_TRUE(runs_that_fit(0, 32, 0).empty()); }

TEST(Batches, what_does_not_fit_is_halved_until_it_does) {
  EXPECT_EQ(runs_that_fit(100, 1, 30), (std::vector<Part>{{0, 25}, {25, 50}, {50, 75}, {75, 100}}));
}

TEST(Batches, runs_cover_all_in_order_and_begin_at_whole_units) {
  for (const std::int64_t n : {1, 31, 32, 33, 1000, 4097}) {
    for (const std::int64_t most : {32, 50, 64, 999}) {
      std::int64_t next = 0;
      for (const Part& run : runs_that_fit(n, 32, most)) {
        EXPECT_EQ(run.begin, next);
        EXPECT_EQ(run.begin % 32, 0);
        next = run.end;
      }
      EXPECT_EQ(next, n);
    }
  }
}

TEST(Batches, a_unit_that_does_not_fit_is_an_error) {
  EXPECT_THROW(runs_that_fit(100, 32, 31), OutOfDeviceMemory);
}

TEST(Batches, other_errors_are_let_through) {
  EXPECT_THROW(in_batches(10, 1, [](std::int64_t, std::int64_t) { throw DeviceError("lost"); }), DeviceError);
}

TEST(Launches, more_indices_than_a_grid_holds_go_in_several) {
  const std::int64_t n = 3 * most_indices_in_a_launch - 5;
  std::int64_t next = 0;
  int launches = 0;
  in_launches(n, [&](std::int64_t begin, std::int64_t end, unsigned blocks) {
    EXPECT_EQ(begin, next);
    EXPECT_LT(blocks, 1U << 31);
    EXPECT_GE(std::int64_t{blocks} * indices_in_a_block, end - begin);
    EXPECT_LT((std::int64_t{blocks} - 1) * indices_in_a_block, end - begin);
    next = end;
    ++launches;
  });
  EXPECT_EQ(next, n);
  EXPECT_EQ(launches, 3);
  in_launches(0, [](std::int64_t, std::int64_t, unsigned) { FAIL(); });
}

}  // namespace
}  // namespace gabarit
