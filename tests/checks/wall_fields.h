// Fields of thickness and clearance of small shapes, for the tests of them.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "checks/check.h"
#include "checks/clearance.h"
#include "checks/thickness.h"
#include "tests/shapes.h"

namespace gabarit {

struct Wanted {
  std::map<std::string, std::string> parameters = {};  // as in a rule file
  double sag = 0.1;
  Extreme extreme = Extreme::smallest;
  double limit = 0, resolution = 0;
  Device device = Device::cpu(1);
};

Field measure(const Measure& measure, const Model& model, const Wanted& wanted = {});
Field thickness(const shapes::Triangles& shape, const Wanted& wanted = {});
// As the engine asks for a limit from below.
Wanted at_least(double limit, double sag = 0.1);

double least_lower(const Field& field);
double least_upper(const Field& field);
double least_value(const Field& field);
bool passes(const Field& field, double limit);  // at least
bool fails(const Field& field, double limit);

// Every facet's bounds hold the truth at its centroid (NaN: not asked), and the value of 99 % of the facets
// is within `relative` of it.
void expect_truth(const shapes::Triangles& shape, const Field& field,
                  const std::function<double(const Vec3d&)>& truth, double relative);

shapes::Triangles l_bracket(double wall, double step);  // 30 x 20 x 40 mm, sharp edges
shapes::Triangles prism(const std::vector<shapes::Point2>& polygon, double length);
// A block of 40 x 10 x 25 mm with a groove of 10 degrees from above whose tip leaves `web`.
shapes::Triangles grooved(double web);
// From 2 to 12 mm over 100 mm, of twelve facets.
shapes::Triangles tapered_plate();

}  // namespace gabarit
