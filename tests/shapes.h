// Small solids with known answers, for the tests of every folder. Outward facets, millimetres.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/model.h"
#include "model/triangle_mesh.h"

namespace gabarit::shapes {

using Triangle = std::array<Vec3d, 3>;
using Triangles = std::vector<Triangle>;

struct Point2 {
  double x, y;
};

// Twelve facets.
Triangles box(const Vec3d& min, const Vec3d& max);
// The same box with every side split into squares of about `step`.
Triangles gridded_box(const Vec3d& min, const Vec3d& max, double step);
// A closed convex polygon (counter-clockwise) swept from z = bottom to top; sides split in `layers`.
Triangles extrude(const std::vector<Point2>& polygon, double bottom, double top, int layers = 1);
// A profile of (radius, z) points turned about z in `segments` steps; wanted bottom to top for outward facets
// of a solid of revolution. Points on the axis give fans; a profile whose last point equals its first gives a
// ring such as a torus.
Triangles revolve(const std::vector<Point2>& profile, int segments);
Triangles sphere(double radius, int rings, int segments);
Triangles torus(double ring_radius, double tube_radius, int ring_segments, int tube_segments);
// An arc of a profile, end points included, `from` and `to` in radians.
std::vector<Point2> arc(Point2 centre, double radius, double from, double to, int steps);

Triangles joined(Triangles a, const Triangles& b);
Triangles moved(Triangles triangles, const Vec3d& by);
// By `angle` radians about the unit `axis` through the origin.
Triangles rotated(Triangles triangles, const Vec3d& axis, double angle);
Triangles flipped(Triangles triangles);
// Order of facets and first corners shuffled by the seed; `order[i]` is the old place of new facet i.
Triangles permuted(const Triangles& triangles, std::uint32_t seed,
                   std::vector<std::uint32_t>* order = nullptr);
// Every interior coordinate rounded to float, as a binary STL would.
Triangles rounded_to_float(Triangles triangles);

// Welded by equal coordinates, facets in order.
TriangleMesh mesh(const Triangles& triangles);
Model model(const Triangles& triangles, double sag = 0.1);

}  // namespace gabarit::shapes
