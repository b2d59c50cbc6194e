// Finds edges that bound a face from both sides.
#pragma once

#include <vector>

#include "model/trim_chain.h"

namespace gabarit {

// Both sides of an edge that a face has twice are made exact images of each other, whole turns apart, and get
// their roles: two curves that differ by rounding would let a ray through between them.
void join_seams(const Face& face, const Surface& surface, std::vector<TrimLoop>& loops);

}  // namespace gabarit
