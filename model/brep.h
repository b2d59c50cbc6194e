// The exact boundary of a model as plain arrays: made once by a loader, read by kernels on any device.
// Millimetres and radians; placements are baked in.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gpu/box.h"
#include "gpu/vec3.h"

namespace gabarit {

using FaceId = std::uint32_t;
using EdgeId = std::uint32_t;
constexpr std::uint32_t no_number = 0xFFFFFFFFU;

struct Parameters {
  double u = 0, v = 0;
};
struct ParameterBox {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
};

// Orthonormal, but left-handed after a mirroring placement.
struct Axes {
  Vec3d origin, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
};

// A pole of a rational spline: (w·x, w·y, w·z, w).
struct Pole {
  double x = 0, y = 0, z = 0, w = 1;
};

enum class CurveKind : std::uint8_t { line, circle, ellipse, hyperbola, parabola, spline };

// C(t), ISO 10303-42's parametrisation:
// line       origin + t·x
// circle     origin + radius·(cos t·x + sin t·y)
// ellipse    origin + radius·cos t·x + minor·sin t·y
// hyperbola  origin + radius·cosh t·x + minor·sinh t·y
// parabola   origin + t²/(4·radius)·x + t·y; `radius` is the focal length
// spline     rational, of its own degree
struct Curve {
  CurveKind kind = CurveKind::line;
  bool periodic = false;  // t is taken modulo last - first
  Axes axes;
  double radius = 0, minor = 0;
  double first = 0, last = 0;  // where it is defined; may be infinite
  std::int32_t degree = 0, pole_count = 0;
  std::uint32_t first_pole = 0, first_knot = 0;  // pole_count + degree + 1 knots, each as often as it counts
};

enum class SurfaceKind : std::uint8_t { plane, cylinder, cone, sphere, torus, extrusion, revolution, spline };
constexpr int surface_kinds = 8;
const char* name(SurfaceKind kind);

// S(u, v), ISO 10303-42's parametrisation, with e(u) = cos u·x + sin u·y:
// plane       origin + u·x + v·y
// cylinder    origin + radius·e(u) + v·z
// cone        origin + (radius + v·sin a)·e(u) + v·cos a·z; a is the half angle, kept in `minor`
// sphere      origin + radius·cos v·e(u) + radius·sin v·z
// torus       origin + (radius + minor·cos v)·e(u) + minor·sin v·z
// extrusion   C(u) + v·z
// revolution  C(v) turned by u about the axis through origin along z
// spline      rational, of its own degrees
struct Surface {
  SurfaceKind kind = SurfaceKind::plane;
  bool u_periodic = false, v_periodic = false;  // parameters are taken modulo the width of the domain
  Axes axes;
  double radius = 0, minor = 0;
  ParameterBox domain;  // may be infinite
  std::uint32_t curve = no_number;
  std::int32_t u_degree = 0, v_degree = 0, u_poles = 0, v_poles = 0;
  std::uint32_t first_pole = 0, first_u_knot = 0, first_v_knot = 0;  // the poles of one u lie together
};

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;  // sRGB
  friend bool operator==(const Colour&, const Colour&) = default;
};

// What the file says of a face besides its shape.
struct FaceLabel {
  std::string name;              // UTF-8; most files name no faces
  std::optional<Colour> colour;  // its own, or else that of its shell or solid
};

struct Face {
  std::uint32_t surface = no_number;
  std::uint32_t body = 0;
  double sign = 1;     // the outward normal is sign · dS/du × dS/dv
  ParameterBox range;  // that holds the trimmed face, inside the surface's domain where that is not periodic
  double tolerance = 0;  // mm
};

// How the surface turns across an edge, seen from outside.
enum class EdgeKind : std::uint8_t { smooth, convex, concave, mixed, boundary };
constexpr int edge_kinds = 5;
const char* name(EdgeKind kind);

struct Edge {
  std::uint32_t curve = no_number;                              // none: a point, such as the pole of a sphere
  double first = 0, last = 0;                                   // on the curve
  std::array<FaceId, 2> faces{no_number, no_number};            // twice the same: a seam
  std::array<std::uint32_t, 2> vertices{no_number, no_number};  // at first and at last
  EdgeKind kind = EdgeKind::boundary;
  double least_turn = 0, greatest_turn = 0;  // radians between the normals along it; convex is positive
  double tolerance = 0;                      // mm
};
// Edges whose normals turn less than this are smooth: files carry tangent edges with noise of a few degrees.
constexpr double smooth_turn = 0.0872664625997164788;  // 5°

struct BrepVertex {
  Vec3d point;
  double tolerance = 0;  // mm
};

// A piece of a face's boundary in the plane of its parameters along which u and v each run one way: its ends
// are its box, and a.v < b.v. Level pieces are not kept.
struct TrimPiece {
  Parameters a, b;
  double first = 0, last = 0;       // at a and at b, on the curve
  std::uint32_t curve = no_number;  // its z is 0; none: straight
  bool seam = false;                // both sides of a seam at once: between a.v and b.v, wherever u is
};

// How a face is cut out of its surface: a point is inside when the pieces that a ray towards greater u meets,
// in all turns of u and v, are odd in number (`all`: even).
struct FaceTrim {
  ParameterBox box;  // of the pieces
  bool all = false;
  std::uint32_t first_piece = 0, piece_count = 0;
  // Bins of equal height over the box: bin i lists trim_listing[trim_bins[first_bin + i] .. [+ 1]]. None: few
  // pieces, look at all.
  std::uint32_t first_bin = 0, bin_count = 0;
};

// Where a facet lies on the exact surface.
struct FacetOrigin {
  FaceId face = no_number;
  std::int8_t u_pole = -1, v_pole = -1;  // the corner where u (or v) means nothing: a pole, an apex
  std::array<Parameters, 3> corners;
};

struct Brep {
  std::vector<Surface> surfaces;
  std::vector<Curve> curves;
  std::vector<Pole> poles;
  std::vector<double> knots;
  std::vector<Face> faces;  // numbered body by body in the order of the file: the same for the same file
  std::vector<FaceLabel> labels;  // one a face
  std::vector<Edge> edges;        // numbered like the faces
  std::vector<BrepVertex> vertices;
  // The edges of face f, a seam once: edges_of_face[first_edge_of_face[f] .. [f + 1]].
  std::vector<std::uint32_t> first_edge_of_face;
  std::vector<EdgeId> edges_of_face;
  std::vector<FaceTrim> trims;  // one a face
  std::vector<TrimPiece> trim_pieces;
  std::vector<std::uint32_t> trim_bins, trim_listing;
  std::vector<FacetOrigin> facets;   // one a facet of the mesh
  std::uint64_t untrimmed = 0;       // faces whose trimming curves are unknown: whole surfaces
  std::uint64_t leaky = 0;           // faces with gaps between trimming curves that no tolerance covers
  std::uint64_t invalid_bodies = 0;  // as they stand in the file, repaired or not
  std::uint64_t approximated = 0;    // surfaces and curves (offsets) that are splines only nearly
  double approximation_error = 0;    // mm: the greatest seen on a grid over each of them
};

}  // namespace gabarit
