// A stand-in for a motorcycle: wheels, tubes and rounded bodies of about 2 m, tessellated to any size.
#pragma once

#include <cstddef>

#include "model/model.h"

namespace gabarit {

// About `facets` facets (within a few per cent), coordinates rounded to float as an STL has them.
Model stand_in(std::size_t facets);

}  // namespace gabarit
