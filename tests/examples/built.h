// The example motorcycle as the tests of this folder look at it.
#pragma once

#include "examples/motorcycle/motorcycle.h"
#include "model/model.h"

namespace gabarit::motorcycle {

struct Built {
  Tessellation tessellation;
  Parts parts;
  std::vector<Grid> grids;
  gabarit::Model model;  // body b is part b
};

// Half as many facets as delivered, and as delivered; each built once.
const Built& coarse();
const Built& delivered();

}  // namespace gabarit::motorcycle
