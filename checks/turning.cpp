#include "checks/turning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "checks/hidden_rounding.h"
#include "checks/reading.h"
#include "checks/roundings.h"
#include "checks/slivers.h"

namespace gabarit {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t grain = 512;
constexpr double degree = std::numbers::pi / 180;

// An edge that turns by more is sharp as far as the mesh tells.
constexpr double sharp = 25 * degree;
// An edge beside a rounding may turn by this share more than half of the rounding's strip does: corners where
// roundings meet are irregular.
constexpr double irregular_rim = 0.5;
// Edges that turn by less, with turning beyond both sides, belong to a surface that is irregular, not sharp…
constexpr double gentle = 6 * degree;
// …whose curvature is taken to be at most so many times the steepest turn over width nearby.
constexpr double irregularity = 3;
// Convex, or it would be if the other facet were the one that looks the wrong way.
bool turns(const Fold& fold) {
  return fold.convex || (!fold.oriented && std::fabs(fold.turn) > fold.noise + smallest_turn);
}

// What the edges of a facet come to.
struct Edges {
  bool explained = true;   // by the roundings beside them, or gentle
  bool convex = false;     // some are
  bool irregular = false;  // some are explained only as gentle
  bool beyond = false;     // some are explained only by roundings beyond the facets beside them
};

class Turning {
 public:
  Turning(const Scene& scene, const Setup& setup, const Region& region, const std::vector<FacetId>& selected);
  Reading read(FacetId f) const;
  std::vector<std::string> notes(const Model& model) const;

 private:
  Reading read_facet(FacetId f) const;
  Reading read_sliver(FacetId f) const;
  const CurvatureFit& fit(FacetId f) const { return roundings_.fit(f); }
  bool on_plane(FacetId f) const;
  bool open(FacetId f) const;
  bool shown_by(FacetId f, const Fold& fold, double curvature, double width) const;
  bool explained(FacetId f, const Fold& fold, double curvature) const;
  bool explained_beyond(FacetId f, const Fold& fold) const;
  bool is_gentle(FacetId f, const Fold& fold) const;
  Selected selected(FacetId f, const Fold& fold) const;
  Edges look_at_edges(FacetId f, Reading& reading) const;
  void limit_by_edge(FacetId f, const Fold& fold, Reading& reading) const;
  void read_value(FacetId f, const Edges& edges, Reading& reading) const;

  const TriangleMesh* mesh_;
  const Region* region_;
  double sag_;
  Roundings roundings_;
  const Folds& folds_;
};

Turning::Turning(const Scene& scene, const Setup& setup, const Region& region,
                 const std::vector<FacetId>& selected)
    : mesh_(&scene.mesh()),
      region_(&region),
      sag_(setup.sag),
      roundings_(scene, selected, setup.sag),
      folds_(roundings_.folds()) {}

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

// Whether a rounding of that curvature explains a fold between strips of it that are `width` apart, and with
// facets that are within the sag: along a rounding facets can be long, and their ends sharp.
bool Turning::shown_by(FacetId f, const Fold& fold, double curvature, double width) const {
  const double most_curvature = (1 + irregular_rim) * curvature;
  return curvature > 0 && fold.turn - fold.noise <= most_curvature * width &&
         largest_rounding(*mesh_, folds_, f, fold, sag_) >= radius(most_curvature);
}

// Whether the fold turns by no more than a surface of that curvature does between the two facets, by half of
// their heights: irregular facets turn a little more.
bool Turning::explained(FacetId f, const Fold& fold, double curvature) const {
  const double here = facet_edge(*mesh_, f, fold.edge).height;
  const double there = facet_edge(*mesh_, fold.facet, fold.other).height;
  const double width = is_rim_here(fold) ? 0.5 * there : 0.5 * (here + there);
  return shown_by(f, fold, curvature, width);
}

// The last strip of a rounding before a narrow flat has doubts, for the flat could share in the turn between
// them. What is sure of the rounding beyond the strip explains its edges, that to the flat as a rim.
bool Turning::explained_beyond(FacetId f, const Fold& fold) const {
  if (!fold.oriented || !fold.turns_here || !fold.turns_there) return false;
  const double here = facet_edge(*mesh_, f, fold.edge).height;
  const double there = facet_edge(*mesh_, fold.facet, fold.other).height;
  const double across = roundings_.confirmed(fold.facet, fold.other) ? most(fit(fold.facet)) : 0;
  return shown_by(f, fold, across, 0.5 * (here + there)) ||
         shown_by(f, fold, roundings_.curvature_beyond(f, fold.edge), 0.5 * here);
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
  Edges edges;
  for (const Fold& fold : folds_.of(f)) {
    if (!turns(fold) || selected(f, fold) == Selected::no) continue;
    edges.convex = true;
    if (fold.oriented && sure && !is_rim_here(fold)) continue;
    // The facet across the edge has its curvature from that very edge, unless this is the rim of a plane.
    const double beside = roundings_.curvature_beside(f, is_rim_here(fold) ? nullptr : &fold);
    if (fold.oriented && explained(f, fold, beside)) continue;
    if (explained_beyond(f, fold)) {
      edges.beyond = true;
      continue;
    }
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
  const double around = roundings_.curvature_around(f);
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
    double most_near = std::max(around, edges.convex ? roundings_.curvature_beside(f) : 0);
    if (edges.beyond) most_near = std::max(most_near, most(own));
    reading.value = edges.convex ? radius(most_near) : infinity;
    reading.lower = radius(std::max(flat, most_near));
  }
}

Reading Turning::read_facet(FacetId f) const {
  Reading reading;
  reading.at = reading.contact = mesh_->centroid(f);
  if (!on_plane(f)) reading.upper = radius(std::min(least(fit(f)), roundings_.least_beside(f)));
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
  if (field.facets.empty()) return field;
  const Turning turning(scene, setup, region, field.facets);
  fill(field, scene.device(), grain, [&](FacetId f) { return turning.read(f); });
  field.notes = turning.notes(scene.model());
  return field;
}

}  // namespace gabarit
