#include "checks/exact_surface.h"

#include <algorithm>
#include <cmath>

#include "checks/edge_pieces.h"
#include "gpu/parallel_for.h"
#include "model/brep_curvature.h"
#include "model/brep_deviation.h"

namespace gabarit {
namespace {

constexpr double margin = 1.25;        // of a greatest distance over that of the samples
constexpr double widest_error = 0.35;  // radians: facets whose normals are worse off have none in the tree
constexpr std::int64_t grain = 256;

Vec3f to_float(const Vec3d& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// How far the normals of the surface under a facet turn away from the facet's; 4 where nobody knows.
double normal_error(const BrepView& brep, const FacetOrigin& origin, const Vec3d& normal) {
  if (origin.face == no_number || normal == Vec3d{}) return 4;
  const Face& face = brep.faces[origin.face];
  double greatest = 0;
  constexpr std::array<std::array<double, 3>, 7> places{
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {.5, .5, 0}, {0, .5, .5}, {.5, 0, .5}, {1 / 3., 1 / 3., 1 / 3.}}};
  for (const auto& w : places) {
    const Vec3d n =
        outward_normal(face_point(brep, face, parameters_at(origin, w[0], w[1], w[2])), face.sign);
    if (n != Vec3d{}) greatest = std::max(greatest, std::atan2(length(cross(n, normal)), dot(n, normal)));
  }
  return greatest;
}

struct FacetErrors {
  std::vector<float> sag;
  std::vector<float> turn;
};

FacetErrors facet_errors(const Model& model, const EdgePieces& pieces, const Device& device) {
  const std::size_t n = model.mesh.facet_count();
  FacetErrors errors{std::vector<float>(n), std::vector<float>(n)};
  const BrepView brep = view(*model.brep);
  const auto kernel = [&](std::int64_t i) {
    const auto f = static_cast<FacetId>(i);
    const double own = margin * greatest_deviation(*model.brep, model.mesh, f, f + 1);
    errors.sag[f] = static_cast<float>(std::max(own, pieces.facet_sags[f]) * (1 + 1e-6));
    errors.turn[f] =
        static_cast<float>(margin * normal_error(brep, model.brep->facets[f], facet_normal(model.mesh, f)));
  };
  parallel_for_cpu(device, static_cast<std::int64_t>(n), kernel, grain);
  return errors;
}

// The tree takes what has no normal for an edge between the first two corners: that is the longest side, and
// the third corner lies within the sag.
Primitive without_normal(const TriangleMesh& mesh, FacetId f, float sag) {
  const std::array<Vec3d, 3> c = mesh.corners(f);
  std::size_t longest = 0;
  const auto side = [&](std::size_t i) { return length(c[(i + 1) % 3] - c[i]); };
  for (const std::size_t i : {1, 2})
    if (side(i) > side(longest)) longest = i;
  const double height = 2 * facet_area(mesh, f) / side(longest);
  const auto& v = mesh.facets[f];
  return {{v[longest], v[(longest + 1) % 3], v[(longest + 2) % 3]},
          f,
          {},
          static_cast<float>((static_cast<double>(sag) + height) * (1 + 1e-6))};
}

}  // namespace

ExactSurface exact_surface(const ExactModel& exact, Side side) {
  const Model& model = exact.model();
  const Device& device = exact.device();
  const TriangleMesh& mesh = model.mesh;
  EdgePieces pieces = edge_pieces(model);
  EdgeCorners corners = edge_corners(model, pieces);
  FacetErrors errors = facet_errors(model, pieces, device);
  FacetSurface surface;
  surface.points = mesh.vertices;
  double error = 0;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const Vec3d normal = facet_normal(mesh, f);
    if (normal == Vec3d{} || model.brep->facets[f].face == no_number) continue;
    const double turn = errors.turn[f];
    const bool sure = turn <= widest_error;
    if (sure) error = std::max(error, turn);
    const Vec3d seen = side == Side::inside ? normal : -normal;
    surface.primitives.push_back(sure ? Primitive{mesh.facets[f], f, to_float(seen), errors.sag[f]}
                                      : without_normal(mesh, f, errors.sag[f]));
  }
  auto id = static_cast<std::uint32_t>(mesh.facet_count());
  for (std::uint32_t i = 0; i < pieces.pieces.size(); ++i, ++id)
    surface.primitives.push_back({{pieces.ends[i][0], pieces.ends[i][1], i},
                                  id,
                                  {},
                                  static_cast<float>(pieces.sags[i] * (1 + 1e-6) + 1e-9)});
  const auto first_corner = static_cast<std::uint32_t>(pieces.pieces.size());
  for (std::uint32_t i = 0; i < corners.corners.size(); ++i, ++id)
    surface.primitives.push_back({{corners.vertices[i], corners.vertices[i], first_corner + i}, id, {}, 0});
  // Nothing is said about the directions in which the surface leaves them: empty fans.
  surface.fan_first.assign(first_corner + corners.corners.size() + 1, 0);
  const auto greatest = std::max_element(errors.turn.begin(), errors.turn.end());
  const double greatest_turn = errors.turn.empty() ? 0 : *greatest;
  return {Bvh(device, std::move(surface)),
          {device, std::move(pieces.pieces)},
          {device, std::move(corners.corners)},
          {device, std::move(corners.directions)},
          {device, std::move(errors.sag)},
          {device, std::move(errors.turn)},
          error,
          greatest_turn,
          length(bounding_box(mesh).extent()),
          side,
          &exact};
}

ExactView ExactSurface::view() const {
  return {exact->view(),     tree.view(),
          facet_sags.view(), facet_turns.view(),
          pieces.view(),     corners.view(),
          directions.view(), side == Side::inside ? 1.0 : -1.0,
          normal_error,      size};
}

std::size_t ExactSurface::bytes() const {
  return tree.bytes() + pieces.bytes() + corners.bytes() + directions.bytes() + facet_sags.bytes() +
         facet_turns.bytes();
}

}  // namespace gabarit
