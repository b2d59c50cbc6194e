#include "tests/checks/wall_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "rules/read_value.h"
#include "tests/block_solid.h"

namespace gabarit {

using shapes::Point2;
using shapes::Triangles;

Field measure(const Measure& measure, const Model& model, const Wanted& wanted) {
  Arguments arguments;
  for (const Parameter& parameter : measure.parameters) {
    const auto given = wanted.parameters.find(parameter.name);
    if (given != wanted.parameters.end())
      arguments.set(parameter.name, *read_value(parameter, given->second));
  }
  fill_defaults(measure.parameters, arguments);
  Setup setup;
  setup.sag = wanted.sag;
  setup.extreme = wanted.extreme;
  setup.limit = wanted.limit;
  setup.resolution = wanted.resolution;
  return measure.measure(Scene(model, wanted.device), setup, whole_model(model.mesh), arguments);
}

Field thickness(const shapes::Triangles& shape, const Wanted& wanted) {
  return measure(thickness_measure, shapes::model(shape, wanted.sag), wanted);
}

Wanted at_least(double limit, double sag) { return {.sag = sag, .limit = limit, .resolution = limit / 2}; }

double least_lower(const Field& field) { return *std::min_element(field.lower.begin(), field.lower.end()); }
double least_upper(const Field& field) { return *std::min_element(field.upper.begin(), field.upper.end()); }
double least_value(const Field& field) { return *std::min_element(field.value.begin(), field.value.end()); }
bool passes(const Field& field, double limit) { return least_lower(field) >= limit; }
bool fails(const Field& field, double limit) { return least_upper(field) < limit; }

void expect_truth(const Triangles& shape, const Field& field,
                  const std::function<double(const Vec3d&)>& truth, double relative) {
  std::size_t near = 0, counted = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const shapes::Triangle& t = shape[field.facets[i]];
    const double t_true = truth((t[0] + t[1] + t[2]) / 3.0);
    if (std::isnan(t_true)) continue;
    ++counted;
    EXPECT_LE(field.lower[i], t_true * (1 + 1e-9))
        << "facet " << field.facets[i] << " value " << field.value[i];
    EXPECT_GE(field.upper[i], t_true * (1 - 1e-9))
        << "facet " << field.facets[i] << " value " << field.value[i];
    if (std::fabs(field.value[i] - t_true) <= relative * t_true) ++near;
  }
  EXPECT_GT(counted, 0U);
  EXPECT_GE(static_cast<double>(near), 0.99 * static_cast<double>(counted));
}

Triangles l_bracket(double wall, double step) {
  shapes::BlockSolid solid;
  solid.lines = {{{0, wall, 30}, {0, 20}, {0, wall, 40}}};
  solid.filled = [](int i, int, int k) { return i == 0 || k == 0; };
  const TriangleMesh mesh = shapes::surface(solid, step);
  Triangles out;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) out.push_back(mesh.corners(f));
  return out;
}

Triangles prism(const std::vector<Point2>& polygon, double length) {
  return shapes::extrude(polygon, 0, length);
}

Triangles grooved(double web) {
  const double half = (10 - web) * std::tan(5 * std::numbers::pi / 180);
  const std::vector<Point2> outline{{0, 0},    {40, 0},         {40, 10}, {20 + half, 10},
                                    {20, web}, {20 - half, 10}, {0, 10}};
  Triangles out;
  const auto at = [&](std::size_t i, double z) {
    const Point2 p = outline[i % outline.size()];
    return Vec3d{p.x, p.y, z};
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    out.push_back({at(i, 0), at(i + 1, 0), at(i + 1, 25)});
    out.push_back({at(i, 0), at(i + 1, 25), at(i, 25)});
  }
  for (const auto& [i, j, k] :
       std::vector<std::array<std::size_t, 3>>{{0, 1, 4}, {1, 2, 3}, {1, 3, 4}, {0, 4, 5}, {0, 5, 6}}) {
    out.push_back({at(i, 25), at(j, 25), at(k, 25)});
    out.push_back({at(k, 0), at(j, 0), at(i, 0)});
  }
  return out;
}

Triangles tapered_plate() { return prism({{0, 0}, {100, 0}, {100, 12}, {0, 2}}, 60); }

}  // namespace gabarit
