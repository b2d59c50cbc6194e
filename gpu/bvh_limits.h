// Sizes that every way of building a tree keeps to.
#pragma once

#include <cstdint>

namespace gabarit {

// What one node can hold in leaves that are not quite full; parts of this size are not split between nodes.
constexpr std::uint32_t bottom_size = 48;
constexpr std::uint32_t usual_leaf_size = 6;
// From this depth on ranges are halved by count: no input makes the tree deeper than the queries' stacks.
constexpr int greatest_sah_depth = 14;

}  // namespace gabarit
