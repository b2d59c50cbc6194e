// Where the axes of the model point in a picture.
#pragma once

#include <array>

#include "report/camera.h"

namespace gabarit {

struct TriadAxis {
  char name = 'x';  // x, y or z of the model
  PagePoint tip;  // of a unit arrow from the origin, to the right and up; (0, 0) when it points at the reader
  double toward = 0;  // the rest of the unit length: 1 points at the reader, -1 away
};

// The one that points away most comes first: drawn in this order, nearer arrows cover farther ones.
std::array<TriadAxis, 3> triad(const Camera& camera);

}  // namespace gabarit
