// How far the true surface may lie from each facet, told from how the mesh bends there.
#pragma once

#include <span>
#include <vector>

#include "gpu/device.h"
#include "model/adjacency.h"

namespace gabarit {

// mm, one a facet. Across each edge that is no crease, two chords of one circle, as wide as the facets and
// bent by their angle, tell how far they lie off it; the three edges add up, as the curvatures of two
// directions do, and the halves of a quad in one plane share the greater sum. 5 % more are allowed for. Where
// a facet is more than twice as wide as its neighbour the surface is taken to change there (a plane that a
// fillet leaves), and twice the neighbour's width counts. Facets whose neighbours are all in their plane lie
// on the surface: 0. Never more than `declared`. Holds on tessellated cylinders, spheres and tori.
// `normals`: those of the facets.
std::vector<float> local_sag(const TriangleMesh& mesh, std::span<const Vec3d> normals,
                             const Adjacency& adjacency, double crease, double declared,
                             const Device& device);

}  // namespace gabarit
