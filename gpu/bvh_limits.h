// Sizes that every way of building a tree keeps to.
#pragma once

#include <cstdint>

namespace gabarit {

// What one node can hold in leaves that are not quite full; parts of this size are not split between nodes.
constexpr std::uint32_t bottom_size = 48;
constexpr std::uint32_t usual_leaf_size = 6;
// From this depth on ranges are halved by count: fewer than 2^28 primitives are in leaves eleven levels on.
constexpr int greatest_sah_depth = 14;
// Of nodes in a row from the root down; the queries' stacks have room for it.
constexpr int greatest_depth = greatest_sah_depth + 11;

}  // namespace gabarit
