#include "checks/flood.h"

#include <random>
#include <string>

#include <gtest/gtest.h>

namespace gabarit {
namespace {

// One character a cell; a hash is closed.
struct Plan {
  CellGrid grid;
  std::vector<float> value;
};

Plan plan(const std::vector<std::string>& rows) {
  Plan out{{{0, 0}, 1, static_cast<std::int64_t>(rows[0].size()), static_cast<std::int64_t>(rows.size())},
           {}};
  for (const std::string& row : rows) {
    for (const char c : row) out.value.push_back(c == '#' ? 0.0F : 1.0F);
  }
  return out;
}

std::string flooded(const std::vector<std::string>& rows) {
  const Plan p = plan(rows);
  std::string out;
  for (const std::uint8_t cell : flood(p.grid, p.value, 1)) out += cell != 0 ? 'o' : '.';
  return out;
}

TEST(Flood, a_closed_room_stays_dry) {
  EXPECT_EQ(flooded({"      ", " #### ", " #  # ", " #### ", "      "}),
            "oooooo"
            "o....o"
            "o....o"
            "o....o"
            "oooooo");
}

TEST(Flood, a_way_leads_through_corners) {
  EXPECT_EQ(flooded({"     ", " ### ", " # # ", " ##  ", "     "}),
            "ooooo"
            "o...o"
            "o.o.o"
            "o..oo"
            "ooooo");
}

TEST(Flood, a_winding_corridor_is_followed_to_its_end) {
  EXPECT_EQ(flooded({" #   ", " # # ", " # # ", "   # "}),
            "o.ooo"
            "o.o.o"
            "o.o.o"
            "ooo.o");
}

// Spreads from cell to cell until nothing changes.
std::vector<std::uint8_t> spread(const Plan& p, double free) {
  std::vector<std::uint8_t> reached(p.value.size(), 0);
  reached[0] = 1;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::int64_t i = 0; i < p.grid.count(); ++i) {
      const std::int64_t x = i % p.grid.columns;
      if (reached[static_cast<std::size_t>(i)] != 0 || p.value[static_cast<std::size_t>(i)] < free) continue;
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        for (std::int64_t dx = -1; dx <= 1; ++dx) {
          const std::int64_t next = i + dy * p.grid.columns + dx;
          if (x + dx < 0 || x + dx >= p.grid.columns || next < 0 || next >= p.grid.count()) continue;
          if (reached[static_cast<std::size_t>(next)] == 0) continue;
          reached[static_cast<std::size_t>(i)] = 1;
          changed = true;
        }
      }
    }
  }
  return reached;
}

TEST(Flood, random_plans_fill_as_far_as_spreading_cell_by_cell) {
  std::mt19937 random(5);
  for (const unsigned closed : {30U, 50U, 60U, 65U}) {
    Plan p{{{0, 0}, 1, 60, 45}, {}};
    for (std::int64_t i = 0; i < p.grid.count(); ++i)
      p.value.push_back(random() % 100 < closed ? 0.0F : 1.0F);
    p.value[0] = 1;
    EXPECT_EQ(flood(p.grid, p.value, 1), spread(p, 1)) << closed;
  }
}

}  // namespace
}  // namespace gabarit
