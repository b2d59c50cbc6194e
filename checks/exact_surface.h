// The exact surfaces of a model as balls and rays meet them from one side. A tree over the facets, the pieces
// of the edges between them and the corners finds what is near; each of them knows the exact thing that it
// stands for.
#pragma once

#include <array>
#include <vector>

#include "checks/contact_surface.h"
#include "checks/exact_model.h"
#include "gpu/bvh.h"

namespace gabarit {

// A piece of an edge as long as one side of a facet.
struct EdgePiece {
  EdgeId edge = no_number;  // none: no curve of the Brep runs here; the straight line stands for it
  double first = 0,
         last = 0;  // on the edge's curve, at the ends; the face of side 0 lies left of first..last
  Vec3d a, b;
  struct Beside {
    FaceId face = no_number;       // none: a free edge
    std::array<Parameters, 2> at;  // at the ends, nearly
    Vec3d mean;                    // of the outward normals at the ends
    double spread = 0;             // radians: how far normals along the piece may turn away from it
  };
  std::array<Beside, 2> beside;
  // Radians between the normals of its sides, at least and at most; positive where it is convex.
  double least_turn = -4, greatest_turn = 4;
  double tolerance = 0;  // mm: how far the curve may lie from the faces
};

// A corner: a vertex where edges end.
struct EdgeCorner {
  Vec3d point;
  Vec3d outward;  // mean of the normals around it, where they agree; else zero
  std::uint32_t first_direction = 0, direction_count = 0;  // in which the surface leaves it
};

struct ExactView : ExactModelView {
  BvhView tree;  // a primitive's id below facets.size is a facet; of a piece corner[2] is its number, of a
                 // corner too, counted on
  View<const float> facet_sags;   // mm: how far the surface lies from a facet
  View<const float> facet_turns;  // radians: how far the surface's normals turn away from a facet's
  View<const EdgePiece> pieces;
  View<const EdgeCorner> corners;
  View<const Vec3d> directions;
  double side = 1;          // -1: seen from outside
  double normal_error = 0;  // radians: how far a facet's normal in the tree may be off the surface's
  double size = 0;          // mm: diagonal
};

struct ExactSurface {
  Bvh tree;
  Buffer<EdgePiece> pieces;
  Buffer<EdgeCorner> corners;
  Buffer<Vec3d> directions;
  Buffer<float> facet_sags, facet_turns;
  double normal_error = 0;   // radians: how far a facet's normal in the tree may be off the surface's
  double greatest_turn = 0;  // radians: by which normals of surfaces turn away from those of their facets
  double size = 0;
  Side side = Side::inside;
  const ExactModel* exact = nullptr;

  ExactView view() const;  // of the device's memory
  std::size_t bytes() const;
};

// Where `exact` is, which must outlive it. Facets lie as far from the surface as ten samples of each say, and
// a quarter more.
ExactSurface exact_surface(const ExactModel& exact, Side side);

}  // namespace gabarit
