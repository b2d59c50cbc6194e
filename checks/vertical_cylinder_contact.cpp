#include "checks/vertical_cylinder_contact.h"

#include <array>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "checks/contact_depth.h"
#include "checks/contact_notes.h"
#include "checks/dexel_path.h"
#include "checks/reach_grid.h"
#include "checks/reach_proof.h"
#include "checks/reachable_sides.h"
#include "checks/sweep.h"

namespace gabarit {
namespace {

// Rear-facing by more than float noise on a side wall.
constexpr double rear_facing = 1e-3;

Selected state(bool nominal, bool smaller, bool larger) {
  if (nominal && smaller && larger) return Selected::yes;
  return nominal || smaller || larger ? Selected::maybe : Selected::no;
}

// The lowest depth and, for each of the three radii, whether it is touched; of a facet and of its edges.
struct Touch {
  std::array<bool, 3> facet{};
  std::array<std::array<bool, 3>, 3> edge{};  // by edge, then radius
};

void select(Region& region, const std::vector<PlanSide>& sides,
            const std::array<std::vector<float>, 3>& depth) {
  const auto touches = [&](std::size_t radius, std::size_t side) {
    return depth[radius][side] < std::numeric_limits<float>::infinity();
  };
  for (std::size_t begin = 0; begin < sides.size();) {
    const FacetId f = sides[begin].facet;
    Touch touch;
    for (; begin < sides.size() && sides[begin].facet == f; ++begin) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (!touches(k, begin)) continue;
        touch.facet[k] = true;
        if (sides[begin].edge < 3) touch.edge[sides[begin].edge][k] = true;
      }
      region.depth[f] = std::min(region.depth[f], depth[0][begin]);
    }
    region.facets[f] = state(touch.facet[0], touch.facet[1], touch.facet[2]);
    for (std::size_t e = 0; e < 3; ++e)
      region.edges[f][e] = state(touch.edge[e][0], touch.edge[e][1], touch.edge[e][2]);
  }
}

void drop_rear_facing(Region& region, const TriangleMesh& mesh, const Frame& frame) {
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    if (region.facets[f] == Selected::no) continue;
    if (frame.direction_to_vehicle(facet_normal(mesh, f)).x <= rear_facing) continue;
    region.facets[f] = Selected::no;
    region.edges[f].fill(Selected::no);
  }
}

}  // namespace

// Between the lines; 0 when there are none.
static double dexel_spacing(const VerticalCylinder& column) {
  return column.method == ContactMethod::dexel ? column.spacing : 0;
}

struct Disk {
  double radius, tolerance;
  double apart = 0;  // of the places that are known of its path
};

// The true disk, one that surely reaches and touches what the true surface lets it touch, and one that only
// touches what it lets it touch for sure. From a place of the path there may be a diagonal of a square to one
// that dexels know of, and what they take for a way may be narrower by half of it on either side.
static std::array<Disk, 3> disks(const VerticalCylinder& column, double sag) {
  const double diagonal = dexel_spacing(column) * std::numbers::sqrt2;
  return {{{column.radius, column.tolerance},
           {column.radius - sag, column.tolerance, diagonal},
           {column.radius + sag + diagonal / 2, column.tolerance}}};
}

static DiskPath path_of(const VerticalCylinder& column, double radius, const OutlineFeatures& outline,
                        const ReachGrid& reach, const Device& device) {
  if (column.method == ContactMethod::dexel) return dexel_path(outline, radius, column.spacing, device);
  return disk_path(outline, radius, device, &reach);
}

// What a grid proves to be reached and the path does not know of is not left out: maybe selected.
static void doubt_missed(Region& region, const std::vector<std::uint8_t>& missed) {
  std::size_t count = 0;
  for (FacetId f = 0; f < missed.size(); ++f) {
    if (missed[f] == 0) continue;
    ++count;
    region.facets[f] = either(region.facets[f], Selected::maybe);
    for (Selected& edge : region.edges[f]) edge = either(edge, Selected::maybe);
  }
  if (count > 0)
    region.notes.push_back(fmt::format(
        "The path of the column is not whole: a coarse grid reaches places beside {} facets that it leaves "
        "out. They may be selected. This is a fault of the program: please report it with the model.",
        count));
}

static void check(const VerticalCylinder& column, double sag) {
  if (!(column.radius > sag)) throw std::invalid_argument("the column's radius must be larger than the sag");
  if (column.method == ContactMethod::exact) return;
  if (!(column.spacing > 0 && column.spacing < (column.radius - sag) / 2))
    throw std::invalid_argument("the spacing of dexels must be less than a quarter of the column's diameter");
  if (column.motion == Motion::sweep)
    throw std::invalid_argument(
        "the dexel method knows places of the column, not the way between them: use "
        "method: exact for motion: sweep");
}

Region vertical_cylinder_contact(const Scene& scene, const Setup& setup, const VerticalCylinder& column) {
  const TriangleMesh& mesh = scene.mesh();
  check(column, setup.sag);
  Region region;
  region.facets.assign(mesh.facet_count(), Selected::no);
  region.edges.assign(mesh.facet_count(), {Selected::no, Selected::no, Selected::no});
  region.depth.assign(mesh.facet_count(), std::numeric_limits<float>::infinity());
  const PlanProjection plan(mesh, setup.frame, setup.height_band, scene.device());
  if (plan.empty()) {
    region.notes = contact_notes(region, mesh, plan, {}, 0);
    return region;
  }

  const std::array<Disk, 3> disk = disks(column, setup.sag);
  const ReachGrid reach(plan, disk[1].radius, disk[2].radius, disk[1].tolerance + disk[1].apart,
                        scene.device());
  const std::vector<PlanSide> sides = reachable_sides(plan, reach);
  const OutlineFeatures outline = outline_features(sides);
  const ContactDepth contact(sides, column.radius, scene.device());
  std::array<DiskPath, 3> paths;
  std::array<std::vector<float>, 3> depths;
  std::vector<std::uint8_t> missed;
  for (std::size_t k = 0; k < 3; ++k) {
    paths[k] = path_of(column, disk[k].radius, outline, reach, scene.device());
    if (k == 0)
      missed = missed_by(paths[k], reach, dexel_spacing(column) * std::numbers::sqrt2, scene.device());
    if (column.motion == Motion::sweep) paths[k] = sweep_part(paths[k]);
    depths[k] = contact.along(paths[k], disk[k].tolerance, disk[k].apart);
    if (setup.progress) setup.progress(0.3 + 0.2 * static_cast<double>(k + 1));
  }
  select(region, sides, depths);
  if (column.motion == Motion::forward) drop_rear_facing(region, mesh, setup.frame);
  region.traces = contact_traces(paths[0], setup.frame);
  region.notes = contact_notes(region, mesh, plan, paths[0], dexel_spacing(column));
  doubt_missed(region, missed);
  return region;
}

static Region select_contact(const Scene& scene, const Setup& setup, const Arguments& arguments) {
  VerticalCylinder column;
  column.radius = arguments.number("diameter") / 2;
  const std::string& motion = arguments.text("motion");
  column.motion = motion == "forward" ? Motion::forward : motion == "sweep" ? Motion::sweep : Motion::any;
  column.tolerance = std::max(1e-3, arguments.has("tolerance") ? arguments.number("tolerance") : setup.sag);
  if (arguments.text("method") == "dexel") column.method = ContactMethod::dexel;
  if (arguments.has("spacing")) {
    if (column.method != ContactMethod::dexel)
      throw std::invalid_argument("spacing is that of dexels: it needs method: dexel beside it");
    column.spacing = arguments.number("spacing");
  }
  return vertical_cylinder_contact(scene, setup, column);
}

static std::string sentence(const Arguments& arguments) {
  const std::string& motion = arguments.text("motion");
  const char* how = motion == "forward" ? "while the vehicle moves forward"
                    : motion == "sweep" ? "while it passes from front to rear on either side"
                                        : "from any side";
  const char* found = arguments.text("method") == "dexel" ? " (by dexels)" : "";
  return fmt::format("a vertical column of {:g} mm diameter can touch it {}{}", arguments.number("diameter"),
                     how, found);
}

const Selector vertical_cylinder_contact_selector{
    .name = "contact",
    .variant = "vertical cylinder",
    .summary = "What a vertical column that stands on the ground can touch from outside.",
    .documentation =
        "The model is clipped to the height band of the rule and projected to the ground. A disk of the "
        "column's diameter rolls along "
        "the projection from outside; what it touches is what the column can touch: the boundary of the "
        "closing of the projection by "
        "the disk. Pockets with a mouth narrower than the diameter stay closed, islands in open yards are "
        "reached, holes are not.\n\n"
        "A facet is touched when it comes nearer to the rolling column than the tolerance. The path is found "
        "for the column's radius and "
        "for the radius plus and minus the sag; what is touched by some of the three only is maybe selected "
        "and can be undecided, never "
        "failed.\n\n"
        "motion: any takes every position of the column. forward drops the facets that face backwards, as "
        "the paper does. sweep keeps the "
        "positions of a column that passes from front to rear on either side, moving outwards freely and "
        "inwards no faster than "
        "rearwards (a reading of EU 44/2014, Annex VIII, 1.2).\n\n"
        "A height selector beside this one, in the same all, says how far up and down the column reaches. "
        "Removing what lies outside that "
        "band can only uncover more of the rest.\n\n"
        "Source: M. Inui, N. Umezu, Extraction of vertical cylinder contacting area for motorcycle safety "
        "verification, Computer-Aided "
        "Design and Applications. The paper samples the plan by dexels of 1 mm; here the path is exact. "
        "method: dexel is the paper's, as a cross-check: the path is known only where the lines of a grid "
        "cross it. What may hang on the places between them, up to 1.4 times the spacing, is maybe selected; "
        "what it selects or leaves out for certain, so does the exact method.",
    .parameters = {{.name = "probe",
                    .dimension = Dimension::choice,
                    .documentation = "The body that touches.",
                    .default_text = {},
                    .choices = {"vertical cylinder"}},
                   {.name = "diameter",
                    .dimension = Dimension::length,
                    .documentation = "Of the column, such as 300 mm.",
                    .default_text = {},
                    .least = 0.01,
                    .greatest = 1e6},
                   {.name = "motion",
                    .dimension = Dimension::choice,
                    .documentation = "How the column moves along the vehicle.",
                    .default_text = "any",
                    .choices = {"any", "forward", "sweep"}},
                   {.name = "tolerance",
                    .dimension = Dimension::length,
                    .documentation = "How near is touching; without it the sag, never less than 0.001 mm.",
                    .default_text = {},
                    .optional = true,
                    .least = 1e-3,
                    .greatest = 10},
                   {.name = "method",
                    .dimension = Dimension::choice,
                    .documentation = "How the path of the column is found.",
                    .default_text = "exact",
                    .choices = {"exact", "dexel"}},
                   {.name = "spacing",
                    .dimension = Dimension::length,
                    .documentation = "Of the lines of dexels, with method: dexel only; without it 0.98 mm.",
                    .default_text = {},
                    .optional = true,
                    .least = 0.01,
                    .greatest = 100}},
    .select = select_contact,
    .height_band = nullptr,
    .sentence = sentence};

}  // namespace gabarit
