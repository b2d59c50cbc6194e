// Lists the trimming pieces of a face by layers of v, so that a query looks at few of them.
#pragma once

#include "model/brep.h"

namespace gabarit {

void sort_into_bins(FaceTrim& trim, Brep& brep);

}  // namespace gabarit
