// Binary PLY of a field: what was measured on every facet of the model, in input order.
#pragma once

#include <string>
#include <vector>

#include "checks/field.h"
#include "checks/region.h"
#include "report/output_file.h"
#include "rules/verdict.h"

namespace gabarit {

struct FieldView {
  const TriangleMesh* mesh = nullptr;
  const Region* region = nullptr;  // one entry a facet; may be empty: nothing selected
  const Field* field = nullptr;
  const std::vector<FacetVerdict>* verdicts = nullptr;  // one an entry of the field; null: nothing was judged
  double factor = 1;                                    // from inside units to those of the file
  std::string title;                                    // a comment in the header, one line
};

// Face properties: vertex_indices, double value (NaN where there is none), double lower, double upper, uchar
// selected (0 no, 1 yes, 2 maybe), uchar verdict (0 not examined, 1 pass, 2 fail, 3 undecided).
void write_ply(const FieldView& view, OutputFile& file);

}  // namespace gabarit
