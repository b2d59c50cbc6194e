#include "checks/turning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "checks/curvature_fit.h"
#include "gpu/parallel_for.h"

namespace gabarit {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t grain = 512;

// Of the fitted curvature: what second order leaves out, measured on roundings of one radius.
constexpr double model_error = 0.03;
// A fit whose edges disagree by more than this share of the curvature has no single curvature to tell.
constexpr double most_doubt = 0.2;
// An edge that turns by more is sharp as far as the mesh tells; below, it may be half of a coarse rounding.
constexpr double sharp = 25 * std::numbers::pi / 180;

// 1/mm: a surface this flat is a plane.
constexpr double flat = 1e-4;

double radius(double curvature) { return curvature > 1e-9 ? 1 / curvature : infinity; }

// Convex, or it would be if the other facet were the one that looks the wrong way.
bool turns(const Fold& fold) {
  return fold.convex || (!fold.oriented && std::fabs(fold.turn) > fold.noise + smallest_turn);
}

struct Reading {
  double value = unknown, lower = 0, upper = infinity;
  Absence absence = Absence::too_little;
  Vec3d at, contact;
};

// How far the facet reaches from its edge, at right angles, at a place along the edge.
double reach(const FacetEdge& e, double at) {
  const double share = at < e.foot ? at / e.foot : (e.length - at) / (e.length - e.foot);
  return e.height * std::clamp(share, 0.0, 1.0);
}

double longest_side(const FacetEdge& e) {
  return std::max({e.length, length(e.apex - e.from), length(e.apex - e.to)});
}

// Any section across the edge gives a bound; three of them.
double largest_rounding(const TriangleMesh& mesh, FacetId f, const Fold& fold, double sag) {
  const FacetEdge here = facet_edge(mesh, f, fold.edge);
  const FacetEdge there = facet_edge(mesh, fold.facet, fold.other);
  const Vec3d along = (here.to - here.from) / here.length;
  const double a = dot(there.from - here.from, along);
  const double b = dot(there.to - here.from, along);
  const double from = std::max(0.0, std::min(a, b));
  const double to = std::min(here.length, std::max(a, b));
  double smallest = infinity;
  for (const double share : {0.25, 0.5, 0.75}) {
    const double at = from + share * (to - from);
    const Leg mine{reach(here, at), longest_side(here)};
    const Leg theirs{reach(there, std::fabs(at - a)), longest_side(there)};
    smallest = std::min(smallest, largest_rounding(fold.turn - fold.noise, sag, mine, theirs));
  }
  return smallest;
}

// By how much a leg can lean away from the tangent of a rounding of radius r at its corner, rad.
double most_lean(const Leg& leg, double r, double sag) {
  const double depth = std::min(sag, leg.longest * leg.longest / (6 * r));
  const double free = std::sqrt(2 * r * depth);  // where the rounding is furthest from the leg
  if (leg.length < free) return depth / leg.length + leg.length / (2 * r);
  return depth < r ? std::acos(1 - depth / r) : std::numbers::pi;
}

class Turning {
 public:
  Turning(const Scene& scene, const Setup& setup, const Region& region, const std::vector<FacetId>& selected);
  Reading read(FacetId f) const;

 private:
  bool trusted(const CurvatureFit& fit) const;
  const CurvatureFit& fit(FacetId f) const { return fits_[place_[f]]; }
  double curvature_beside(FacetId f) const;
  double curvature_around(FacetId f) const;
  double least(const CurvatureFit& fit) const;
  double least_beside(FacetId f) const;
  bool explained(FacetId f, const Fold& fold, double curvature) const;
  bool explained(FacetId f, Reading& reading) const;
  bool on_plane(FacetId f) const;
  void limit_by_edge(FacetId f, const Fold& fold, Reading& reading) const;
  bool open(FacetId f) const;
  Selected selected(FacetId f, const Fold& fold) const;

  const TriangleMesh* mesh_;
  const Region* region_;
  double sag_;
  Folds folds_;
  std::vector<std::uint32_t> place_;  // by facet, in fits_
  std::vector<CurvatureFit> fits_;
};

// Two rings for the bounds, and those that the neighbours' fits look at: edges of neighbours, and two facets
// beyond them.
constexpr int rings = 5;

Turning::Turning(const Scene& scene, const Setup& setup, const Region& region,
                 const std::vector<FacetId>& selected)
    : mesh_(&scene.mesh()), region_(&region), sag_(setup.sag), folds_(scene, selected, rings, setup.sag) {
  const std::vector<FacetId> fitted = folds_.within(selected, 2);
  place_.assign(mesh_->facet_count(), 0);
  fits_.resize(fitted.size());
  for (std::size_t i = 0; i < fitted.size(); ++i) place_[fitted[i]] = static_cast<std::uint32_t>(i);
  const auto kernel = [&](std::int64_t i) {
    const auto at = static_cast<std::size_t>(i);
    fits_[at] = fit_curvature(*mesh_, folds_, fitted[at]);
  };
  parallel_for_cpu(scene.device(), static_cast<std::int64_t>(fitted.size()), kernel, grain);
}

bool Turning::trusted(const CurvatureFit& fit) const {
  return fit.doubt <= most_doubt * std::max(fit.curvature, 0.0) + flat &&
         fit.sag <= (1 + most_doubt / 2) * sag_;
}

// The largest curvature that a neighbour is sure of.
double Turning::curvature_beside(FacetId f) const {
  double largest = 0;
  for (const Fold& fold : folds_.of(f)) {
    const CurvatureFit& there = fit(fold.facet);
    if (there.resolved && trusted(there)) largest = std::max(largest, there.curvature + there.doubt);
  }
  return largest;
}

// The curvature that is there for certain.
double Turning::least(const CurvatureFit& fit) const {
  return fit.resolved && trusted(fit) ? fit.curvature * (1 - model_error) - fit.doubt : 0;
}

// What a neighbour confirms: one facet across a rim can be misled.
double Turning::least_beside(FacetId f) const {
  double largest = 0;
  for (const Fold& fold : folds_.of(f)) largest = std::max(largest, least(fit(fold.facet)));
  return largest;
}

// The same within two edges. A facet across the rim of a rounding that no edges mark reads the mean of what
// it covers; the facets behind it know better.
double Turning::curvature_around(FacetId f) const {
  double largest = 0;
  for (const Fold& fold : folds_.of(f)) largest = std::max(largest, curvature_beside(fold.facet));
  return largest;
}

// Whether the fold turns by no more than a surface of that curvature does between the two facets.
bool Turning::explained(FacetId f, const Fold& fold, double curvature) const {
  const double here = facet_edge(*mesh_, f, fold.edge).height;
  const double there = facet_edge(*mesh_, fold.facet, fold.other).height;
  const double width = is_rim_here(fold) ? 0.5 * there : 0.5 * (here + there);
  return fold.turn - fold.noise <= (1 + most_doubt) * curvature * width;
}

Selected Turning::selected(FacetId f, const Fold& fold) const {
  return either(region_->edge(f, fold.edge), region_->edge(fold.facet, fold.other));
}

bool Turning::open(FacetId f) const {
  std::array<bool, 3> closed{};
  for (const Fold& fold : folds_.of(f)) closed[fold.edge] = true;
  for (int e = 0; e < 3; ++e) {
    if (!closed[static_cast<std::size_t>(e)] && region_->edge(f, e) != Selected::no) return true;
  }
  return false;
}

// An edge that no rounding explains: the largest that can hide between the facets and the true surface is a
// certain upper bound.
void Turning::limit_by_edge(FacetId f, const Fold& fold, Reading& reading) const {
  reading.lower = 0;
  if (!fold.convex || !fold.oriented || selected(f, fold) != Selected::yes) return;
  const double largest = largest_rounding(*mesh_, f, fold, sag_);
  if (largest >= reading.upper) return;
  const FacetEdge edge = facet_edge(*mesh_, f, fold.edge);
  reading.upper = largest;
  reading.contact = 0.5 * (edge.from + edge.to);
  if (fold.turn > sharp) reading.value = 0, reading.absence = Absence::none;
}

// In one plane with what lies beyond its edges, but for rims of roundings: then it is flat itself, however
// sharp those are.
bool Turning::on_plane(FacetId f) const {
  bool any = false;
  for (const Fold& fold : folds_.of(f)) {
    if (is_rim_here(fold)) continue;
    if (std::fabs(fold.turn) > fold.noise + smallest_turn) return false;
    any = true;
  }
  return any;
}

// Whether every selected edge turns by no more than the roundings beside it do; limits the reading by those
// that turn more.
bool Turning::explained(FacetId f, Reading& reading) const {
  const CurvatureFit& own = fit(f);
  const bool resolved = trusted(own) && own.resolved;
  const double beside = curvature_beside(f);
  bool all = true;
  for (const Fold& fold : folds_.of(f)) {
    if (selected(f, fold) == Selected::no || !turns(fold)) continue;
    if (fold.oriented && resolved && !is_rim_here(fold)) continue;
    if (fold.oriented && explained(f, fold, beside)) continue;
    limit_by_edge(f, fold, reading);
    all = false;
  }
  return all;
}

Reading Turning::read(FacetId f) const {
  Reading reading;
  reading.at = reading.contact = mesh_->centroid(f);
  if (facet_normal(*mesh_, f) == Vec3d{}) {
    reading.absence = Absence::degenerate;
    return reading;
  }
  const CurvatureFit& own = fit(f);
  const double beside = curvature_beside(f);
  const double curvature = std::max(own.curvature, 0.0);
  const bool plane = on_plane(f);
  const bool sure = trusted(own) && !plane;
  if (sure && own.resolved) reading.upper = radius(std::min(least(own), least_beside(f)));
  if (explained(f, reading) && (plane || sure || beside > 0)) {
    const double largest = (1 + model_error) * std::max(beside, curvature_around(f));
    reading.value = plane ? infinity : radius(sure ? curvature : beside);
    reading.lower = plane  ? radius(flat)
                    : sure ? radius(std::max(curvature * (1 + model_error) + own.doubt + flat, largest))
                           : radius(largest);
    reading.absence = Absence::none;
  }
  if (open(f)) {
    reading.lower = 0;
    if (reading.upper == infinity) reading.value = unknown, reading.absence = Absence::open;
  }
  return reading;
}

}  // namespace

double largest_rounding(double turn, double sag, const Leg& a, const Leg& b) {
  const auto most_turn = [&](double r) { return most_lean(a, r, sag) + most_lean(b, r, sag); };
  if (!(turn > 0) || most_turn(1e6) >= turn) return infinity;
  double low = 1e-9;
  double high = 1e6;
  while (high > low * (1 + 1e-9)) {
    const double middle = std::sqrt(low * high);
    (most_turn(middle) >= turn ? low : high) = middle;
  }
  return high;
}

Field measure_turning(const Scene& scene, const Setup& setup, const Region& region) {
  Field field;
  field.facets = selected_facets(region);
  field.resize(field.facets.size());
  if (field.facets.empty()) return field;
  const Turning turning(scene, setup, region, field.facets);
  const auto kernel = [&](std::int64_t i) {
    const auto at = static_cast<std::size_t>(i);
    const Reading r = turning.read(field.facets[at]);
    field.value[at] = r.value;
    field.lower[at] = r.lower;
    field.upper[at] = r.upper;
    field.at[at] = r.at;
    field.contact[at] = r.contact;
    field.absence[at] = r.absence;
  };
  parallel_for_cpu(scene.device(), static_cast<std::int64_t>(field.size()), kernel, grain);
  return field;
}

}  // namespace gabarit
