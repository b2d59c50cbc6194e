// Makes a face's trimming pieces from the curves that bound it.
#pragma once

#include <vector>

#include "model/brep.h"

namespace gabarit {

// What a stretch adds to the number of pieces that a ray meets: one where it crosses; one at its height, for
// both sides of a seam together; nothing, where the other side says it all.
enum class TrimRole : std::uint8_t { border, seam, silent };

// A run along a curve in a face's parameter plane, with the face on its left.
struct TrimStretch {
  Parameters start, end;
  std::uint32_t curve = no_number;  // of its own, for it may be moved by whole turns; none: straight
  double first = 0, last = 0;       // on the curve, at start and at end
  EdgeId edge = no_number;          // twice in one face: a seam
  double tolerance = 0;             // mm, of the edge and its vertices
  TrimRole role = TrimRole::border;
};
using TrimWire = std::vector<TrimStretch>;  // closed, in any order

// The trimming of the next face, brep.faces[brep.trims.size()]. No wires: the whole surface belongs to it.
// Ends that do not meet are joined by a straight piece, so that no ray slips through; where their distance is
// more than any tolerance the face is counted as leaky. A seam counts as one piece that lies everywhere,
// wires that wind around a periodic surface without a seam are joined. What cannot be understood (numbers
// that are none, a single loop around a tube) makes the face untrimmed: counted, and whole.
void add_trim(const std::vector<TrimWire>& wires, Brep& brep);
// That of a face whose curves are not known: untrimmed.
void add_unknown_trim(Brep& brep);

}  // namespace gabarit
