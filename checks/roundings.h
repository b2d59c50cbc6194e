// What the facets near a region tell about the roundings that they belong to, each with those around it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "checks/curvature_fit.h"
#include "checks/folds.h"

namespace gabarit {

// 1/mm: a surface this flat is a plane.
constexpr double flat = 1e-4;

// mm, infinite for planes and hollows.
double radius(double curvature);

bool trusted(const CurvatureFit& fit);
bool sure_of_rounding(const CurvatureFit& fit);
// The curvature that is there for certain, and the most that it can be, 1/mm.
double least(const CurvatureFit& fit);
double most(const CurvatureFit& fit);

// Of the facets given and their neighbours; only those can be asked about.
class Roundings {
 public:
  // `sag`: of the facets from the true surface, mm.
  Roundings(const Scene& scene, std::span<const FacetId> facets, double sag);

  const Folds& folds() const { return folds_; }
  const CurvatureFit& fit(FacetId f) const { return fits_[place_[f]]; }

  // The largest curvature that a neighbour is sure of, one across `except` left out, 1/mm.
  double curvature_beside(FacetId f, const Fold* except = nullptr) const;
  // The same within two edges, not across rims of planes and sharp hollows. A facet across the rim of a
  // rounding that no edges mark reads the mean of what it covers; the facets behind it know better.
  double curvature_around(FacetId f) const;
  // The largest curvature that facets beyond f are sure of, as seen from one of its edges.
  double curvature_beyond(FacetId f, int edge) const;
  // Whether facet f is sure of its curvature and has it not from this edge alone: what lies beyond is sure of
  // one too, or reads the same.
  bool confirmed(FacetId f, int edge) const;
  // What a neighbour confirms. One facet across a rim can be misled, and so can the flat between two
  // roundings: where one across an edge that both are curved at has doubts, the facets on the other side have
  // to be sure.
  double least_beside(FacetId f) const;

 private:
  void doubt_coarse(FacetId f, CurvatureFit& fit) const;
  bool shows(FacetId f, const Fold& fold) const;
  template <class Visit>
  void beyond(FacetId f, int edge, const Visit& visit) const;

  const TriangleMesh* mesh_;
  double sag_;
  Folds folds_;
  std::vector<std::uint32_t> place_;  // by facet, in fits_
  std::vector<CurvatureFit> fits_;
};

}  // namespace gabarit
