#include "checks/hidden_rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gabarit {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double straight = 0.01;      // rad: folds that turn by less do not end a leg
constexpr double longest_leg = 20;     // mm
constexpr int most_facets_of_leg = 5;  // no more than the folds around a region know

// By how much a leg can lean away from the tangent of the rounding at its corner, rad.
double most_lean(const Leg& leg, double r, double sag) {
  const double depth = std::min(sag, leg.longest * leg.longest / (6 * r));
  const double furthest = std::sqrt(2 * r * depth);  // where the rounding is furthest from a long leg
  if (leg.length < furthest) return depth / leg.length + leg.length / (2 * r);
  return depth < r ? std::acos(1 - depth / r) : std::numbers::pi;
}

double longest_side(const FacetEdge& e) {
  return std::max({e.length, length(e.apex - e.from), length(e.apex - e.to)});
}

// How far the facet reaches from its edge, at right angles, at a place along the edge.
double reach(const FacetEdge& e, double at) {
  const double share = at < e.foot ? at / e.foot : (e.length - at) / (e.length - e.foot);
  return e.height * std::clamp(share, 0.0, 1.0);
}

// The part of the edge that both facets share, as lengths along the edge of f.
struct Shared {
  double from, to;
};

Shared shared_part(const FacetEdge& here, const FacetEdge& there) {
  const Vec3d along = (here.to - here.from) / here.length;
  const double a = dot(there.from - here.from, along);
  const double b = dot(there.to - here.from, along);
  return {std::max(0.0, std::min(a, b)), std::min(here.length, std::max(a, b))};
}

double place_along(const FacetEdge& e, const Vec3d& p) {
  return std::clamp(dot(p - e.from, e.to - e.from) / e.length, 0.0, e.length);
}

struct Exit {
  double distance = 0;
  int edge = -1;
};

// Where a ray in the plane of the facet leaves it; it entered through `entry`.
Exit leave(const TriangleMesh& mesh, FacetId f, int entry, const Vec3d& p, const Vec3d& d) {
  const Vec3d normal = facet_normal(mesh, f);
  Exit best;
  for (int edge = 0; edge < 3; ++edge) {
    if (edge == entry) continue;
    const FacetEdge e = facet_edge(mesh, f, edge);
    const Vec3d outward = cross(e.to - e.from, normal);
    const double speed = dot(d, outward);
    if (!(speed > 0)) continue;
    const double distance = std::max(0.0, dot(e.from - p, outward) / speed);
    if (best.edge < 0 || distance < best.distance) best = {distance, edge};
  }
  return best;
}

// The neighbour behind an edge at a point of it, when the surface goes straight on there.
const Fold* straight_on(const TriangleMesh& mesh, const Folds& folds, FacetId f, int edge, const Vec3d& p) {
  for (const Fold& fold : folds.of(f)) {
    if (fold.edge != edge || !fold.oriented || std::fabs(fold.turn) > straight + fold.noise) continue;
    const FacetEdge e = facet_edge(mesh, fold.facet, fold.other);
    const double at = dot(p - e.from, e.to - e.from) / e.length;
    if (at >= -1e-6 * e.length && at <= (1 + 1e-6) * e.length) return &fold;
  }
  return nullptr;
}

// From a point of an edge at right angles to it, over facets in one plane.
Leg leg(const TriangleMesh& mesh, const Folds& folds, FacetId f, int edge, Vec3d p) {
  Leg leg{0, 0};
  const FacetEdge first = facet_edge(mesh, f, edge);
  Vec3d d = cross(facet_normal(mesh, f), (first.to - first.from) / first.length);
  for (int i = 0; i < most_facets_of_leg && leg.length < longest_leg; ++i) {
    const Exit exit = leave(mesh, f, edge, p, d);
    if (exit.edge < 0) break;
    leg.length += exit.distance;
    leg.longest = std::max(leg.longest, longest_side(facet_edge(mesh, f, exit.edge)));
    p += d * exit.distance;
    const Fold* const next = straight_on(mesh, folds, f, exit.edge, p);
    if (next == nullptr) break;
    f = next->facet;
    edge = next->other;
    const Vec3d normal = facet_normal(mesh, f);
    d = normalized(d - normal * dot(d, normal));
  }
  return leg;
}

}  // namespace

double most_turn(double r, double sag, const Leg& a, const Leg& b) {
  return most_lean(a, r, sag) + most_lean(b, r, sag);
}

double largest_rounding(double turn, double sag, const Leg& a, const Leg& b) {
  double low = 1e-9;
  double high = 1e6;
  if (!(turn > 0) || most_turn(high, sag, a, b) >= turn) return infinity;
  while (high > low * (1 + 1e-9)) {
    const double middle = std::sqrt(low * high);
    (most_turn(middle, sag, a, b) >= turn ? low : high) = middle;
  }
  return high;
}

double largest_rounding(const TriangleMesh& mesh, const Folds& folds, FacetId f, const Fold& fold,
                        double sag) {
  const FacetEdge here = facet_edge(mesh, f, fold.edge);
  const Shared shared = shared_part(here, facet_edge(mesh, fold.facet, fold.other));
  double smallest = infinity;
  for (const double share : {0.25, 0.5, 0.75}) {
    const double at = shared.from + share * (shared.to - shared.from);
    const Vec3d p = here.from + (here.to - here.from) * (at / here.length);
    const Leg mine = leg(mesh, folds, f, fold.edge, p);
    const Leg theirs = leg(mesh, folds, fold.facet, fold.other, p);
    smallest = std::min(smallest, largest_rounding(fold.turn - fold.noise, sag, mine, theirs));
  }
  return smallest;
}

bool too_coarse(const TriangleMesh& mesh, FacetId f, const Fold& fold, double r, double sag) {
  const FacetEdge here = facet_edge(mesh, f, fold.edge);
  const FacetEdge there = facet_edge(mesh, fold.facet, fold.other);
  const Shared shared = shared_part(here, there);
  const double at = 0.5 * (shared.from + shared.to);
  const Vec3d p = here.from + (here.to - here.from) * (at / here.length);
  const Leg mine{reach(here, at), longest_side(here)};
  const Leg theirs{reach(there, place_along(there, p)), longest_side(there)};
  return fold.turn - fold.noise > most_turn(r, sag, mine, theirs);
}

}  // namespace gabarit
