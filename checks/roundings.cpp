#include "checks/roundings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "checks/hidden_rounding.h"
#include "gpu/parallel_for.h"

namespace gabarit {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::int64_t grain = 512;
constexpr double degree = std::numbers::pi / 180;

// Shares of a curvature that second order adds and leaves out, beside what the edges' disagreement tells:
// measured on roundings of one radius, coarse ones read too sharp by up to 1 %, hardly any too round.
constexpr double model_error = 0.01;
constexpr double overlooked = 0.001;
// A fit whose edges disagree by more than this share of the curvature has no single curvature to tell.
constexpr double most_doubt = 0.2;
// A hollow that turns by more parts two surfaces.
constexpr double sharp = 25 * degree;
// Edges that turn by less may belong to a surface that is irregular.
constexpr double gentle = 6 * degree;
// A fold shows a rounding when it turns by this share of what the rounding does there.
constexpr double good_part = 0.5;
// Curvatures that differ by a smaller share are the same. Strips beside a flat that is wide enough to make
// them doubtful differ from it by a quarter and more.
constexpr double agreement = 0.1;
// Four rings of fits, for what lies beyond the neighbours of a sliver's neighbours, and those that they look
// at: edges of neighbours, and two facets beyond them.
constexpr int fitted_rings = 4;
constexpr int rings = 7;

// Whether the fold parts two surfaces.
bool parts(const Fold& fold) { return is_rim_here(fold) || fold.turn < -sharp; }

// Whether the first edge lies on the far side of the facet as seen from the other, and runs along it.
bool is_opposite(const FacetEdge& far, const FacetEdge& e) {
  constexpr double least_cosine = 0.7;
  const Vec3d along = (e.to - e.from) / e.length;
  const Vec3d across = 0.5 * (far.from + far.to) - e.from;
  const double distance = length(across - along * dot(across, along));
  return std::fabs(dot(far.to - far.from, along)) > least_cosine * far.length && distance > 0.4 * e.height &&
         distance < 2.5 * e.height;
}

}  // namespace

double radius(double curvature) { return curvature > 1e-9 ? 1 / curvature : infinity; }

bool trusted(const CurvatureFit& fit) {
  return fit.doubt <= most_doubt * std::max(fit.curvature, 0.0) + flat;
}
bool sure_of_rounding(const CurvatureFit& fit) { return fit.resolved && trusted(fit); }

double least(const CurvatureFit& fit) {
  return sure_of_rounding(fit) ? fit.curvature * (1 - model_error) - fit.doubt : 0;
}
double most(const CurvatureFit& fit) { return std::max(fit.curvature, 0.0) * (1 + overlooked) + fit.doubt; }

Roundings::Roundings(const Scene& scene, std::span<const FacetId> facets, double sag)
    : mesh_(&scene.mesh()), sag_(sag), folds_(scene, facets, rings, sag) {
  const std::vector<FacetId> fitted = folds_.within(facets, fitted_rings);
  place_.assign(mesh_->facet_count(), 0);
  fits_.resize(fitted.size());
  for (std::size_t i = 0; i < fitted.size(); ++i) place_[fitted[i]] = static_cast<std::uint32_t>(i);
  const auto kernel = [&](std::int64_t i) {
    const auto at = static_cast<std::size_t>(i);
    fits_[at] = fit_curvature(*mesh_, folds_, fitted[at]);
    doubt_coarse(fitted[at], fits_[at]);
  };
  parallel_for_cpu(scene.device(), static_cast<std::int64_t>(fitted.size()), kernel, grain);
}

// A regular polygon fits a circle perfectly; that its sides leave the circle by more than the sag tells them
// apart.
void Roundings::doubt_coarse(FacetId f, CurvatureFit& fit) const {
  if (!sure_of_rounding(fit)) return;
  const double r = radius(fit.curvature) * (1 - most_doubt / 2);
  for (const Fold& fold : folds_.of(f)) {
    if (fold.convex && fold.oriented && !is_rim_here(fold) && too_coarse(*mesh_, f, fold, r, sag_))
      fit.doubt = infinity;
  }
}

double Roundings::curvature_beside(FacetId f, const Fold* except) const {
  double largest = 0;
  for (const Fold& fold : folds_.of(f)) {
    if (&fold != except && sure_of_rounding(fit(fold.facet)))
      largest = std::max(largest, most(fit(fold.facet)));
  }
  return largest;
}

double Roundings::curvature_around(FacetId f) const {
  double largest = 0;
  for (const Fold& fold : folds_.of(f)) {
    if (parts(fold)) continue;
    if (sure_of_rounding(fit(fold.facet))) largest = std::max(largest, most(fit(fold.facet)));
    for (const Fold& next : folds_.of(fold.facet)) {
      if (!parts(next) && sure_of_rounding(fit(next.facet)))
        largest = std::max(largest, most(fit(next.facet)));
    }
  }
  return largest;
}

// Whether both sides of the fold are curved and it turns by a good part of what the facet across it reads.
bool Roundings::shows(FacetId f, const Fold& fold) const {
  if (!fold.convex || !fold.oriented || !fold.turns_here || !fold.turns_there) return false;
  const double here = facet_edge(*mesh_, f, fold.edge).height;
  const double there = facet_edge(*mesh_, fold.facet, fold.other).height;
  return fold.turn > good_part * fit(fold.facet).curvature * 0.5 * (here + there);
}

// The fits of the facets that f curves on into as seen from one of its edges: beyond its other edges or,
// since most strips are quadrilaterals cut in two, beyond the other half.
template <class Visit>
void Roundings::beyond(FacetId f, int edge, const Visit& visit) const {
  const FacetEdge e = facet_edge(*mesh_, f, edge);
  for (const Fold& fold : folds_.of(f)) {
    if (fold.edge == edge) continue;
    if (shows(f, fold) && is_opposite(facet_edge(*mesh_, f, fold.edge), e)) visit(fit(fold.facet));
    for (const Fold& far : folds_.of(fold.facet)) {
      if (far.edge == fold.other || !shows(fold.facet, far)) continue;
      if (is_opposite(facet_edge(*mesh_, fold.facet, far.edge), e)) visit(fit(far.facet));
    }
  }
}

double Roundings::curvature_beyond(FacetId f, int edge) const {
  double largest = 0;
  beyond(f, edge, [&](const CurvatureFit& far) {
    if (sure_of_rounding(far)) largest = std::max(largest, most(far));
  });
  return largest;
}

bool Roundings::confirmed(FacetId f, int edge) const {
  const CurvatureFit& own = fit(f);
  bool any = false;
  beyond(f, edge, [&](const CurvatureFit& far) {
    any = any || sure_of_rounding(far) ||
          (far.doubt < far.curvature && std::fabs(far.curvature - own.curvature) < agreement * own.curvature);
  });
  return any && sure_of_rounding(own);
}

double Roundings::least_beside(FacetId f) const {
  double largest = 0;
  for (const Fold& fold : folds_.of(f)) {
    const CurvatureFit& there = fit(fold.facet);
    const bool curved = fold.turn > gentle && fold.turns_here && fold.turns_there;
    if (curved && !sure_of_rounding(there) && !confirmed(f, fold.edge)) return 0;
    largest = std::max(largest, least(there));
  }
  return largest;
}

}  // namespace gabarit
