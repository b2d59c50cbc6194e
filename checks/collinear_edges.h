// Edges of an outline that lie on one line made into one.
#pragma once

#include "checks/outline_features.h"

namespace gabarit {

// Of the edges parallel to x or to y, those that lie on the same line, have their area on the same side and
// overlap or meet become one edge; points inside it that no other edge needs go. The outline is the same set
// of places. A flat wall that is parallel to an axis would else be there once for each row of its facets.
// Edges in other directions are not collinear once their coordinates are rounded.
OutlineFeatures join_collinear(const OutlineFeatures& outline);

}  // namespace gabarit
