// A model's surface as balls and rays meet it from one side: facets, and the edges and vertices that a ball
// can touch without touching a facet.
#pragma once

#include <array>
#include <vector>

#include "gpu/bvh.h"
#include "model/adjacency.h"

namespace gabarit {

enum class Side { inside, outside };

struct SurfaceOptions {
  Side side = Side::inside;
  double crease = 0.7;  // radians; across wider bends the mesh stands for two surfaces
  double sag = 0.1;     // declared, mm

  friend auto operator<=>(const SurfaceOptions&, const SurfaceOptions&) = default;
};

struct ContactSurface {
  Bvh tree;                                   // ids of facets are facet numbers, those of features follow
  std::vector<std::array<Vec3f, 3>> normals;  // smooth, by facet and corner; zero without a normal
  std::vector<float> sag;                     // local, by facet, mm
  double size = 0;                            // diagonal of the surface, mm
  bool closed = false;                        // every edge has a neighbour that runs the opposite way
};

ContactSurface contact_surface(const TriangleMesh& mesh, const Adjacency& adjacency,
                               const SurfaceOptions& options, const Device& device);

}  // namespace gabarit
