#include "checks/turning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "checks/curvature_fit.h"
#include "checks/hidden_rounding.h"
#include "checks/slivers.h"
#include "gpu/parallel_for.h"

namespace gabarit {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t grain = 512;
constexpr double degree = std::numbers::pi / 180;

// Shares of a curvature that second order adds and leaves out, beside what the edges' disagreement tells:
// measured on roundings of one radius, coarse ones read too sharp by up to 1 %, hardly any too round.
constexpr double model_error = 0.01;
constexpr double overlooked = 0.001;
// A fit whose edges disagree by more than this share of the curvature has no single curvature to tell.
constexpr double most_doubt = 0.2;
// 1/mm: a surface this flat is a plane.
constexpr double flat = 1e-4;
// An edge that turns by more is sharp as far as the mesh tells.
constexpr double sharp = 25 * degree;
// An edge beside a rounding may turn by this share more than half of the rounding's strip does: corners where
// roundings meet are irregular.
constexpr double irregular_rim = 0.5;
// Edges that turn by less, with turning beyond both sides, belong to a surface that is irregular, not sharp…
constexpr double gentle = 6 * degree;
// …whose curvature is taken to be at most so many times the steepest turn over width nearby.
constexpr double irregularity = 3;
// Three rings of fits, and those that they look at: edges of neighbours, and two facets beyond them.
constexpr int fitted_rings = 3;
constexpr int rings = 6;

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

// What the edges of a facet come to.
struct Edges {
  bool explained = true;   // by the roundings beside them, or gentle
  bool convex = false;     // some are
  bool irregular = false;  // some are explained only as gentle
};

class Turning {
 public:
  Turning(const Scene& scene, const Setup& setup, const Region& region, const std::vector<FacetId>& selected);
  Reading read(FacetId f) const;
  std::vector<std::string> notes(const Model& model) const;

 private:
  Reading read_facet(FacetId f) const;
  Reading read_sliver(FacetId f) const;
  const CurvatureFit& fit(FacetId f) const { return fits_[place_[f]]; }
  void doubt_coarse(FacetId f, CurvatureFit& fit) const;
  double curvature_beside(FacetId f) const;
  double curvature_around(FacetId f) const;
  double least_beside(FacetId f) const;
  bool on_plane(FacetId f) const;
  bool open(FacetId f) const;
  bool explained(FacetId f, const Fold& fold, double curvature) const;
  bool is_gentle(FacetId f, const Fold& fold) const;
  Selected selected(FacetId f, const Fold& fold) const;
  Edges look_at_edges(FacetId f, Reading& reading) const;
  void limit_by_edge(FacetId f, const Fold& fold, Reading& reading) const;
  void read_value(FacetId f, const Edges& edges, Reading& reading) const;

  const TriangleMesh* mesh_;
  const Region* region_;
  double sag_;
  Folds folds_;
  std::vector<std::uint32_t> place_;  // by facet, in fits_
  std::vector<CurvatureFit> fits_;
};

bool trusted(const CurvatureFit& fit) {
  return fit.doubt <= most_doubt * std::max(fit.curvature, 0.0) + flat;
}
bool sure_of_rounding(const CurvatureFit& fit) { return fit.resolved && trusted(fit); }

// Whether the fold parts two surfaces.
bool parts(const Fold& fold) { return is_rim_here(fold) || fold.turn < -sharp; }

// The curvature that is there for certain, and the most that it can be.
double least(const CurvatureFit& fit) {
  return sure_of_rounding(fit) ? fit.curvature * (1 - model_error) - fit.doubt : 0;
}
double most(const CurvatureFit& fit) { return std::max(fit.curvature, 0.0) * (1 + overlooked) + fit.doubt; }

Turning::Turning(const Scene& scene, const Setup& setup, const Region& region,
                 const std::vector<FacetId>& selected)
    : mesh_(&scene.mesh()), region_(&region), sag_(setup.sag), folds_(scene, selected, rings, setup.sag) {
  const std::vector<FacetId> fitted = folds_.within(selected, fitted_rings);
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
void Turning::doubt_coarse(FacetId f, CurvatureFit& fit) const {
  if (!sure_of_rounding(fit)) return;
  const double r = radius(fit.curvature) * (1 - most_doubt / 2);
  for (const Fold& fold : folds_.of(f)) {
    if (fold.convex && fold.oriented && !is_rim_here(fold) && too_coarse(*mesh_, f, fold, r, sag_))
      fit.doubt = infinity;
  }
}

// The largest curvature that a neighbour is sure of.
double Turning::curvature_beside(FacetId f) const {
  double largest = 0;
  for (const Fold& fold : folds_.of(f)) {
    if (sure_of_rounding(fit(fold.facet))) largest = std::max(largest, most(fit(fold.facet)));
  }
  return largest;
}

// The same within two edges, not across rims of planes and sharp hollows. A facet across the rim of a
// rounding that no edges mark reads the mean of what it covers; the facets behind it know better.
double Turning::curvature_around(FacetId f) const {
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

// What a neighbour confirms: one facet across a rim can be misled.
double Turning::least_beside(FacetId f) const {
  double largest = 0;
  for (const Fold& fold : folds_.of(f)) largest = std::max(largest, least(fit(fold.facet)));
  return largest;
}

// In one plane with what lies beyond its edges, but for rims of roundings and hollows: then it is flat
// itself, however sharp those are.
bool Turning::on_plane(FacetId f) const {
  bool any = false;
  for (const Fold& fold : folds_.of(f)) {
    if (is_rim_here(fold) || fold.turn < -fold.noise - smallest_turn) continue;
    if (fold.turn > fold.noise + smallest_turn) return false;
    any = true;
  }
  return any;
}

bool Turning::open(FacetId f) const {
  std::array<bool, 3> closed{};
  for (const Fold& fold : folds_.of(f)) closed[fold.edge] = true;
  for (int e = 0; e < 3; ++e) {
    if (!closed[static_cast<std::size_t>(e)] && region_->edge(f, e) != Selected::no) return true;
  }
  return false;
}

// Whether the fold turns by no more than a surface of that curvature does between the two facets, by half of
// their heights: irregular facets turn a little more.
bool Turning::explained(FacetId f, const Fold& fold, double curvature) const {
  const double here = facet_edge(*mesh_, f, fold.edge).height;
  const double there = facet_edge(*mesh_, fold.facet, fold.other).height;
  const double width = is_rim_here(fold) ? 0.5 * there : 0.5 * (here + there);
  return curvature > 0 && fold.turn - fold.noise <= (1 + irregular_rim) * curvature * width;
}

bool Turning::is_gentle(FacetId f, const Fold& fold) const {
  if (fold.turn > gentle || is_rim_here(fold) || is_rim_there(fold)) return false;
  return !too_coarse(*mesh_, f, fold, radius(fit(f).steepest), sag_);
}

Selected Turning::selected(FacetId f, const Fold& fold) const {
  return either(region_->edge(f, fold.edge), region_->edge(fold.facet, fold.other));
}

// An edge that no rounding explains: the largest that can hide there is a certain upper bound.
void Turning::limit_by_edge(FacetId f, const Fold& fold, Reading& reading) const {
  if (!fold.convex || !fold.oriented || selected(f, fold) != Selected::yes) return;
  const double largest = largest_rounding(*mesh_, folds_, f, fold, sag_);
  if (largest >= reading.upper) return;
  const FacetEdge edge = facet_edge(*mesh_, f, fold.edge);
  reading.upper = largest;
  reading.contact = 0.5 * (edge.from + edge.to);
  if (fold.turn > sharp) reading.value = 0, reading.absence = Absence::none;
}

Edges Turning::look_at_edges(FacetId f, Reading& reading) const {
  const bool sure = sure_of_rounding(fit(f));
  const double beside = curvature_beside(f);
  Edges edges;
  for (const Fold& fold : folds_.of(f)) {
    if (!turns(fold) || selected(f, fold) == Selected::no) continue;
    edges.convex = true;
    if (fold.oriented && sure && !is_rim_here(fold)) continue;
    if (fold.oriented && explained(f, fold, beside)) continue;
    if (fold.oriented && is_gentle(f, fold)) {
      edges.irregular = true;
      continue;
    }
    edges.explained = false;
    limit_by_edge(f, fold, reading);
  }
  return edges;
}

// Of a facet whose edges are explained.
void Turning::read_value(FacetId f, const Edges& edges, Reading& reading) const {
  const CurvatureFit& own = fit(f);
  const double around = curvature_around(f);
  reading.absence = Absence::none;
  if (on_plane(f)) {
    reading.value = infinity;
    reading.lower = radius(flat);
  } else if (edges.irregular) {
    reading.lower = radius(std::max(around, irregularity * own.steepest));
    reading.value = std::clamp(radius(own.curvature), reading.lower, reading.upper);
  } else if (trusted(own)) {
    reading.value = radius(own.curvature);
    reading.lower = radius(std::max(most(own) + flat, around));
  } else {
    // Hollow, or flat beside a hollow.
    const double most_near = std::max(around, edges.convex ? curvature_beside(f) : 0);
    reading.value = edges.convex ? radius(most_near) : infinity;
    reading.lower = radius(std::max(flat, most_near));
  }
}

Reading Turning::read_facet(FacetId f) const {
  Reading reading;
  reading.at = reading.contact = mesh_->centroid(f);
  if (!on_plane(f)) reading.upper = radius(std::min(least(fit(f)), least_beside(f)));
  const Edges edges = look_at_edges(f, reading);
  if (edges.explained) read_value(f, edges, reading);
  if (open(f)) {
    reading.lower = 0;
    if (reading.upper == infinity) reading.value = unknown, reading.absence = Absence::open;
  }
  return reading;
}

// A sliver has no direction of its own: it is as round as the less certain of the facets beside it.
Reading Turning::read_sliver(FacetId f) const {
  Reading worst;
  worst.lower = infinity;
  for (const Fold& fold : folds_.of(f)) {
    const Reading beside = read_facet(fold.facet);
    if (beside.lower < worst.lower || (beside.lower == worst.lower && beside.upper < worst.upper))
      worst = beside;
  }
  if (worst.lower == infinity) worst.lower = 0;
  worst.at = worst.contact = mesh_->centroid(f);
  return worst;
}

Reading Turning::read(FacetId f) const {
  if (facet_normal(*mesh_, f) != Vec3d{}) return is_sliver(*mesh_, f) ? read_sliver(f) : read_facet(f);
  Reading reading;
  reading.absence = Absence::degenerate;
  reading.at = reading.contact = mesh_->centroid(f);
  return reading;
}

std::vector<std::string> Turning::notes(const Model& model) const {
  std::vector<std::string> notes;
  for (const std::uint32_t body : folds_.inside_out()) {
    notes.push_back(fmt::format(
        "The facets of `{}` look inwards: rounded and hollow cannot be told apart, what turns is undecided.",
        body < model.bodies.size() ? model.bodies[body] : std::to_string(body)));
  }
  return notes;
}

}  // namespace

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
  field.notes = turning.notes(scene.model());
  return field;
}

}  // namespace gabarit
