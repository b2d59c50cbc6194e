// Binary STL of chosen facets, for loading back into CAD. Millimetres.
#pragma once

#include <string>
#include <vector>

#include "model/triangle_mesh.h"
#include "report/output_file.h"
#include "rules/outcome.h"

namespace gabarit {

// In the order of `facets`, as oriented in the model. `title` goes into the 80-byte header. Coordinates are
// rounded to float, as the format wants: those that came from a binary STL in millimetres come back bit for
// bit.
void write_stl(const TriangleMesh& mesh, const std::vector<FacetId>& facets, const std::string& title,
               OutputFile& file);

// Ascending.
std::vector<FacetId> failing_facets(const RuleResult& result);
// Of all rules, each facet once, ascending.
std::vector<FacetId> failing_facets(const Outcome& outcome);

}  // namespace gabarit
