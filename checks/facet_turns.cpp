#include "checks/facet_turns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "gpu/parallel_for.h"
#include "model/brep_kinks.h"
#include "model/brep_turn.h"
#include "model/edge_table.h"

namespace gabarit {
namespace {

constexpr std::int64_t grain = 256;
constexpr float unknown_turn = std::numeric_limits<float>::infinity();

struct Pair {
  HalfEdgeId a, b;
};

// The outward normal at the share t of the half-edge; none right at a pole, where it would be rounding noise.
Vec3d normal_along(const BrepView& brep, const FacetOrigin& facet, HalfEdgeId h, double t) {
  std::array<double, 3> w{};
  w[h % 3] = 1 - t;
  w[(h + 1) % 3] = t;
  for (const std::int8_t pole : {facet.u_pole, facet.v_pole}) {
    if (pole >= 0 && w[static_cast<std::size_t>(pole)] == 1) return {};
  }
  return normal_at(brep, facet.face, parameters_at(facet, w[0], w[1], w[2]));
}

// Whether the surface is the same function of the same parameters on both sides of the edge.
bool inside_face(const Brep& brep, const Pair& pair) {
  const FacetOrigin &f = brep.facets[pair.a / 3], &g = brep.facets[pair.b / 3];
  if (f.face != g.face) return false;
  for (const std::uint32_t end : {0U, 1U}) {
    const Parameters p = f.corners[(pair.a + end) % 3], q = g.corners[(pair.b + 1 - end) % 3];
    if (p.u != q.u || p.v != q.v) return false;
  }
  return true;
}

float turn_of(const Brep& brep, const BrepView& arrays, const TriangleMesh& mesh, const Pair& pair) {
  const FacetOrigin &f = brep.facets[pair.a / 3], &g = brep.facets[pair.b / 3];
  const Vec3d along = mesh.corner(pair.a / 3, static_cast<int>((pair.a + 1) % 3)) -
                      mesh.corner(pair.a / 3, static_cast<int>(pair.a % 3));
  double greatest = 0;
  bool any = false;
  for (const double t : {0.0, 0.5, 1.0}) {
    const auto turn =
        turn_between(normal_along(arrays, f, pair.a, t), normal_along(arrays, g, pair.b, 1 - t), along);
    if (!turn) continue;
    greatest = any ? std::max(greatest, *turn) : *turn;
    any = true;
  }
  return any ? static_cast<float>(greatest) : unknown_turn;
}

// The turn from just before to just after the kink; `along` has the side before it on its left.
double turn_at_kink(const BrepView& brep, const Face& face, Parameters at, bool in_u) {
  Parameters before = at;
  (in_u ? before.u : before.v) = std::nextafter(in_u ? at.u : at.v, -std::numeric_limits<double>::infinity());
  const SurfacePoint a = face_point(brep, face, before), b = face_point(brep, face, at);
  const Vec3d along = in_u ? a.dv * face.sign : a.du * -face.sign;
  return turn_between(outward_normal(a, face.sign), outward_normal(b, face.sign), along).value_or(0);
}

float kink_turn(const BrepView& brep, const FacetOrigin& facet, const Kinks& kinks) {
  const Face& face = brep.faces[facet.face];
  const auto& c = facet.corners;
  const auto [u0, u1] = std::minmax({c[0].u, c[1].u, c[2].u});
  const auto [v0, v1] = std::minmax({c[0].v, c[1].v, c[2].v});
  double greatest = 0;
  // Not at the very ends: at a pole the normals are rounding noise.
  for (const double share : {0.02, 0.5, 0.98}) {
    for (const double k : kinks.u) {
      if (k >= u0 && k <= u1)
        greatest = std::max(greatest, turn_at_kink(brep, face, {k, v0 + share * (v1 - v0)}, true));
    }
    for (const double k : kinks.v) {
      if (k >= v0 && k <= v1)
        greatest = std::max(greatest, turn_at_kink(brep, face, {u0 + share * (u1 - u0), k}, false));
    }
  }
  return static_cast<float>(greatest);
}

}  // namespace

std::vector<float> facet_turns(const Brep& brep, const TriangleMesh& mesh, const Device& device) {
  std::vector<float> turns(3 * mesh.facet_count(), 0);
  std::vector<Pair> pairs;
  EdgeTable(mesh).for_each_edge([&](std::span<const HalfEdgeId> edge) {
    if (edge.size() != 2 || !run_opposite(mesh, edge[0], edge[1])) {
      for (const HalfEdgeId h : edge) turns[h] = unknown_turn;
    } else if (const Pair pair{edge[0], edge[1]}; !inside_face(brep, pair)) {
      pairs.push_back(pair);
    }
  });
  const BrepView arrays = view(brep);
  const auto kernel = [&](std::int64_t i) {
    const Pair& pair = pairs[static_cast<std::size_t>(i)];
    turns[pair.a] = turns[pair.b] = turn_of(brep, arrays, mesh, pair);
  };
  parallel_for_cpu(device, static_cast<std::int64_t>(pairs.size()), kernel, grain);
  return turns;
}

std::vector<float> kink_turns(const Brep& brep, const Device& device) {
  const std::vector<Kinks> all = kinks(brep);
  if (std::all_of(all.begin(), all.end(), [](const Kinks& k) { return k.u.empty() && k.v.empty(); }))
    return {};
  const BrepView arrays = view(brep);
  std::vector<float> turns(brep.facets.size(), 0);
  const auto kernel = [&](std::int64_t i) {
    const FacetOrigin& facet = brep.facets[static_cast<std::size_t>(i)];
    turns[static_cast<std::size_t>(i)] = kink_turn(arrays, facet, all[brep.faces[facet.face].surface]);
  };
  parallel_for_cpu(device, static_cast<std::int64_t>(turns.size()), kernel, grain);
  return turns;
}

}  // namespace gabarit
