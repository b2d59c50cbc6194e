// The largest ball on one side of an exact surface that touches it at a given point: what maximal_spheres
// finds on facets, found on the trimmed faces and edges that the facets stand for. Facets and chords only say
// where to look; every value comes from the surfaces themselves. After G. Lemasson et al., WSCG 2014,
// with the separation angle of the mesh method.
#pragma once

#include <span>
#include <vector>

#include "checks/exact_surface.h"

namespace gabarit {

enum class BallContact : std::uint8_t {
  none,        // nothing up to the greatest radius
  face,        // inside a face
  edge,        // on an edge: of a face that is a contact, or a reflex one
  vertex,      // at an edge's end
  curvature,   // the surface at the point itself, without a separation angle only
  separation,  // on a face where its normal turns away by just the separation angle
};
const char* name(BallContact kind);

struct ExactBallQuery {
  Vec3d point;               // on the surface
  Vec3d direction;           // unit, across it, towards the centre of the ball
  double own_curvature = 0;  // 1/mm, the greatest that the ball sees at the point
  FaceId face = 0;           // that the point lies on
};

struct ExactBallOptions {
  double cos_separation = 1;
  double greatest_radius = std::numeric_limits<double>::infinity();
  double contact_floor = 0;  // contacts this close to the point are not contacts, mm
};

struct ExactBall {
  double radius = std::numeric_limits<double>::infinity();
  Vec3d contact;
  BallContact kind = BallContact::none;
  FaceId face = no_number;  // of the contact; of an edge the first of its faces
  EdgeId edge = no_number;
  Parameters at;                    // on the face
  std::uint32_t piece = no_number;  // of the edge
  double t = 0;                     // on the edge
  double tolerance = 0;             // mm, of the face or edge of the contact
  double residual = 0;              // mm, see FaceFoot
  int steps = 0;                    // of Newton's method, for all starts together
  int starts = 0;
  bool verified = false;  // nothing that the facets and their sag let come nearer was left unsettled
};

// Answers in the order of the queries, computed where the surface is; neighbouring queries should lie close
// together. The same bits on every device and any number of threads. Throws DeviceError, and
// OutOfDeviceMemory when not even few queries fit.
void exact_balls(const ExactSurface& surface, const ExactBallOptions& options,
                 std::span<const ExactBallQuery> queries, std::span<ExactBall> balls);

}  // namespace gabarit
