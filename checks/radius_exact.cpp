#include "checks/radius_exact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "checks/facet_turns.h"
#include "checks/patch_curvature.h"
#include "checks/reading.h"
#include "checks/rolled_ball.h"
#include "model/edge_table.h"

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double flat = 1e-9;     // 1/mm: a surface this flat is a plane
constexpr double rounding = 1e6;  // radii are multiples of 1e-6 mm
constexpr std::int64_t grain = 128;

double radius(double curvature) {
  return curvature > flat ? std::round(rounding / curvature) / rounding : infinity;
}

class ExactRadius {
 public:
  ExactRadius(const Scene& scene, const Region& region)
      : mesh_(&scene.mesh()),
        brep_(&*scene.model().brep),
        arrays_(view(*brep_)),
        region_(&region),
        turns_(facet_turns(*brep_, *mesh_, scene.device())),
        kinks_(kink_turns(*brep_, scene.device())),
        constant_(rolled_balls(*brep_, scene.device())),
        other_(3 * mesh_->facet_count()) {
    for (std::size_t h = 0; h < other_.size(); ++h) other_[h] = static_cast<HalfEdgeId>(h);
    EdgeTable(*mesh_).for_each_edge([&](std::span<const HalfEdgeId> edge) {
      if (edge.size() == 2) other_[edge[0]] = edge[1], other_[edge[1]] = edge[0];
    });
  }

  Reading read(FacetId f) const {
    Reading reading;
    if (facet_normal(*mesh_, f) == Vec3d{}) return degenerate(f);
    const FacetOrigin& origin = brep_->facets[f];
    const double constant = constant_[origin.face];
    const bool by_kind =
        constant > 0 || alike_everywhere(brep_->surfaces[brep_->faces[origin.face].surface].kind);
    const HalfEdgeId h = 3 * f;
    const FacetDomain domain =
        by_kind ? FacetDomain{} : facet_domain(*brep_, f, {other_[h], other_[h + 1], other_[h + 2]});
    const SharpestPoint point = sharpest_point(arrays_, origin, domain, constant);
    if (std::isnan(point.curvature)) return unknown(f);
    reading.value = reading.upper = radius(point.curvature);
    reading.lower = radius(point.most);
    reading.absence = Absence::none;
    reading.at = face_point(arrays_, brep_->faces[origin.face], point.at).p;
    reading.contact = reading.at;
    for (std::uint32_t e = 0; e < 3; ++e) look_at_edge(f, e, reading);
    if (!kinks_.empty() && kinks_[f] > smooth_turn) make_sharp(mesh_->centroid(f), reading);
    return reading;
  }

 private:
  static bool alike_everywhere(SurfaceKind kind) {
    return kind == SurfaceKind::plane || kind == SurfaceKind::cylinder || kind == SurfaceKind::sphere;
  }

  // The surface has no normal there: nothing is known of it.
  Reading unknown(FacetId f) const {
    Reading reading;
    reading.absence = Absence::too_little;
    reading.at = reading.contact = mesh_->centroid(f);
    return reading;
  }

  Reading degenerate(FacetId f) const {
    Reading reading;
    reading.absence = Absence::degenerate;
    reading.at = reading.contact = mesh_->centroid(f);
    return reading;
  }

  static void make_sharp(const Vec3d& where, Reading& reading) {
    reading.value = reading.lower = reading.upper = 0;
    reading.absence = Absence::none;
    reading.contact = where;
  }

  // An edge counts when it is selected on either of its sides.
  Selected selected(HalfEdgeId h) const {
    const auto side = [&](HalfEdgeId s) { return region_->edge(s / 3, static_cast<int>(s % 3)); };
    return either(side(h), side(other_[h]));
  }

  void look_at_edge(FacetId f, std::uint32_t e, Reading& reading) const {
    const HalfEdgeId h = 3 * f + e;
    const float turn = turns_[h];
    if (!(turn > smooth_turn)) return;
    const Selected looked_at = selected(h);
    if (looked_at == Selected::no) return;
    const Vec3d middle =
        (mesh_->corner(f, static_cast<int>(e)) + mesh_->corner(f, static_cast<int>((e + 1) % 3))) / 2.0;
    const bool known = std::isfinite(turn);
    if (known && looked_at == Selected::yes) return make_sharp(middle, reading);
    reading.lower = 0;
    if (!known && reading.upper == infinity) {
      reading.value = std::numeric_limits<double>::quiet_NaN();
      reading.absence = Absence::open;
    }
  }

  const TriangleMesh* mesh_;
  const Brep* brep_;
  BrepView arrays_;
  const Region* region_;
  std::vector<float> turns_, kinks_;
  std::vector<double> constant_;   // by face: see rolled_balls
  std::vector<HalfEdgeId> other_;  // by half-edge: the one on the other side, itself at free edges
};

}  // namespace

Field measure_exact_radius(const Scene& scene, const Region& region) {
  Field field;
  field.facets = selected_facets(region);
  if (field.facets.empty()) return field;
  const ExactRadius exact(scene, region);
  fill(field, scene.device(), grain, [&](FacetId f) { return exact.read(f); });
  field.notes.push_back(
      "Radii are read from the exact surfaces of the model, not from its facets, and rounded to 1e-6 mm; an "
      "edge is "
      "sharp where its faces turn by more than 5 degrees.");
  return field;
}

}  // namespace gabarit
