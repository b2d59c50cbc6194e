// The radius by turning of small shapes, for the tests of it.
#pragma once

#include "checks/field.h"
#include "checks/region.h"
#include "tests/shapes.h"

namespace gabarit {

Field measured(const TriangleMesh& mesh, double sag, const Region& region, int threads = 1);
// Everywhere.
Field measured(const shapes::Triangles& triangles, double sag = 0.1);
// A roof of two planes that meet at an edge of the given turn, radians.
shapes::Triangles roof(double turn, double width, double length);

}  // namespace gabarit
