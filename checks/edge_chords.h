// The edges of a B-Rep as chords in a tree, each with where it lies on the curve and on the faces beside it:
// the starts for what a ball meets on an edge.
#pragma once

#include <vector>

#include "gpu/bvh.h"
#include "model/brep_view.h"
#include "model/model.h"

namespace gabarit {

struct EdgeChord {
  EdgeId edge = no_number;
  double first = 0, last = 0;                   // on the curve
  std::array<std::array<Parameters, 2>, 2> at;  // on the edge's faces: at first and at last
  std::array<Vec3d, 2> normal{};                // outward, of the faces in the middle; zero without one
  double lean = 0;                              // by which they turn along the chord to either side, radians
};

struct EdgeChords {
  Bvh tree;  // ids are places in `chords`; the sag is how far the curve leaves the chord
  std::vector<EdgeChord> chords;
};

// Of every edge with a curve and a face whose two sides are not the same smooth face.
EdgeChords edge_chords(const Model& model, const Device& device);

// By facet: how far the normals of the exact surface turn away from the facet's, radians; at its corners and
// its middle.
std::vector<float> facet_leans(const Model& model, const Device& device);

}  // namespace gabarit
