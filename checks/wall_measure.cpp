#include "checks/wall_measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "checks/ball_probe.h"
#include "checks/buried.h"
#include "checks/clear_cells.h"
#include "checks/exact_ray_probe.h"
#include "checks/exact_refinement.h"
#include "checks/ray_probe.h"

namespace gabarit {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double no_limit = 1e300;

bool by_ray(const Arguments& arguments) { return arguments.text("method") == "ray"; }

double separation(const Arguments& arguments) {
  if (arguments.has("separation")) return arguments.number("separation");
  return (arguments.text("method") == "wall" ? 120 : 20) * degree;
}

double greatest(const Arguments& arguments) {
  return arguments.has("greatest") ? arguments.number("greatest") : no_limit;
}

void check_used(const Arguments& arguments) {
  if (by_ray(arguments) && arguments.has("separation"))
    throw std::invalid_argument("method ray takes every facet that a ray meets: it has no separation");
  if (!by_ray(arguments) && arguments.number("cone") > 0)
    throw std::invalid_argument("a cone needs method ray");
}

BallOptions ball_options(Side side, Extreme extreme, const Arguments& arguments) {
  return {
      .side = side, .separation = separation(arguments), .greatest = greatest(arguments), .extreme = extreme};
}

RayOptions ray_options(Side side, const Arguments& arguments) {
  return {.side = side,
          .cone = arguments.number("cone"),
          .rays = static_cast<int>(arguments.number("rays")),
          .mean = arguments.text("cone value") == "mean",
          .greatest = greatest(arguments)};
}

Probe probe_of(Side side, const ContactSurface& surface, const TriangleMesh& mesh, Extreme extreme,
               const Arguments& arguments) {
  if (by_ray(arguments)) return ray_probe(surface, mesh, ray_options(side, arguments));
  return ball_probe(surface, ball_options(side, extreme, arguments));
}

// Between exact surfaces, along rays or by balls.
struct ExactSearch {
  std::optional<ExactWalls> balls;
  std::optional<ExactRayWalls> rays;

  ExactSearch(Side side, const Scene& scene, const ContactSurface& surface, Extreme extreme,
              const Arguments& arguments) {
    if (by_ray(arguments)) {
      rays.emplace(scene, surface, ray_options(side, arguments));
    } else {
      balls.emplace(scene, surface,
                    ExactWallOptions{.side = side,
                                     .separation = separation(arguments),
                                     .greatest = greatest(arguments),
                                     .extreme = extreme});
    }
  }
  std::vector<ExactWall> operator()(std::span<const FacetPlace> places) const {
    return rays ? rays->measure(places) : balls->measure(places);
  }
  Probe probe(Probe base, Extreme extreme) const {
    if (rays) return exact_ray_probe(std::move(base), *rays, extreme);
    return exact_probe(std::move(base), *balls, extreme);
  }
};

std::string count_text(std::size_t n) { return n == 1 ? "1 facet" : fmt::format("{} facets", n); }

std::size_t count(const Field& field, Absence absence) {
  return static_cast<std::size_t>(std::count(field.absence.begin(), field.absence.end(), absence));
}

void add_absences(Field& field) {
  if (const std::size_t open = count(field, Absence::open); open > 0)
    field.notes.push_back(fmt::format(
        "Nothing bounds the measure at {}: the mesh is open, its facets face the wrong way or no wall lies "
        "opposite there.",
        count_text(open)));
  if (const std::size_t buried = count(field, Absence::buried); buried > 0)
    field.notes.push_back(fmt::format(
        "The mesh overlaps itself: {} that would read less than asked for lie inside the part and "
        "bound no wall. They have no value.",
        count_text(buried)));
}

void add_notes(Field& field, Side side, double step, const Arguments& arguments) {
  field.notes.push_back(fmt::format(
      "Method: {}; {} normals. Facets longer than {:.3g} mm were looked at in more than one place "
      "where it matters.",
      method_text(arguments), arguments.text("normals"), step));
  add_absences(field);
  const double cap = greatest(arguments);
  if (cap == no_limit || side == Side::outside) return;
  const auto capped = static_cast<std::size_t>(std::count(field.value.begin(), field.value.end(), cap));
  if (capped > 0)
    field.notes.push_back(
        fmt::format("{} reach the greatest value looked for, {:g} mm.", count_text(capped), cap));
}

bool is_exact(const Scene& scene, const Arguments& arguments) {
  return scene.model().brep && arguments.text("normals") == "smooth";
}

void add_exact_note(Field& field) {
  field.notes.push_back(
      "Values are measured between the exact surfaces of the model, not between its facets. Where the limit "
      "lies near, and at the thinnest places, the least value of each facet was looked for on its surface.");
}

// Thin places are looked at again when they may lie inside the part: those under the limit or, without one,
// under a hundredth of the model.
Probe without_buried(Probe probe, Side side, const ContactSurface& surface, const Setup& setup) {
  if (side == Side::outside || setup.extreme == Extreme::greatest) return probe;
  return set_buried_aside(std::move(probe), surface, setup.limit > 0 ? setup.limit : surface.size / 100);
}

}  // namespace

std::string method_text(const Arguments& arguments) {
  if (by_ray(arguments)) {
    if (!(arguments.number("cone") > 0)) return "ray along the normal";
    return fmt::format("{} of {:g} rays in a cone of {:g} deg about the normal", arguments.text("cone value"),
                       arguments.number("rays"), arguments.number("cone") / degree);
  }
  return fmt::format("{}, the largest ball between surfaces that turn away by at least {:g} deg",
                     arguments.text("method"), std::round(separation(arguments) / degree * 1e6) / 1e6);
}

Field measure_walls(Side side, const Scene& scene, const Setup& setup, const Region& region,
                    const Arguments& arguments) {
  check_used(arguments);
  const bool exact = is_exact(scene, arguments);
  const SurfaceOptions wanted{.side = side, .crease = arguments.number("crease"), .sag = setup.sag};
  const ContactSurface& surface = scene.surface(wanted);
  CellOptions options{.side = side,
                      .smooth = arguments.text("normals") == "smooth",
                      .step = setup.resolution > 0 ? setup.resolution : surface.size / 200,
                      .limit = setup.limit,
                      .exhaustive = by_ray(arguments),
                      .extreme = setup.extreme,
                      .progress = setup.progress};
  if (arguments.has("step")) options.step = arguments.number("step");
  Probe probe = probe_of(side, surface, scene.mesh(), setup.extreme, arguments);
  std::optional<ExactSearch> walls;
  if (exact) {
    walls.emplace(side, scene, surface, setup.extreme, arguments);
    probe = walls->probe(std::move(probe), setup.extreme);
    if (walls->balls && options.limit > 0 && setup.extreme == Extreme::smallest)
      probe = with_clear_cells(std::move(probe), surface, ball_options(side, setup.extreme, arguments),
                               {options.limit, options.step, scene.exact_surface(side).greatest_turn});
    options.limit = 0;  // what lies near it is looked for on the surfaces themselves
  }
  Field field = measure_cells(scene.mesh(), region, surface, options,
                              without_buried(std::move(probe), side, surface, setup));
  add_notes(field, side, options.step, arguments);
  if (walls) {
    const auto measure = [&](std::span<const FacetPlace> places) { return (*walls)(places); };
    if (setup.extreme == Extreme::smallest)
      refine_least(field, scene, measure, {.limit = setup.limit, .facets_bind = !by_ray(arguments)});
    add_exact_note(field);
  }
  return field;
}

std::vector<Parameter> wall_parameters(Side side) {
  const std::string what = side == Side::inside ? "wall" : "gap";
  return {{.name = "method",
           .dimension = Dimension::choice,
           .documentation = "wall: the largest ball between opposite walls. sphere: the largest ball at all. "
                            "ray: the distance along the normal.",
           .default_text = "wall",
           .choices = {"wall", "sphere", "ray"}},
          {.name = "separation",
           .dimension = Dimension::angle,
           .documentation = "Angle by which the normal of what stops the ball must turn away from the "
                            "facet's. Without it 120 deg for method wall, 20 deg for sphere.",
           .default_text = {},
           .optional = true,
           .least = 0,
           .greatest = 170 * degree},
          {.name = "crease",
           .dimension = Dimension::angle,
           .documentation = "Facets that bend by less stand for one smooth surface.",
           .default_text = "40 deg",
           .least = 0,
           .greatest = 90 * degree},
          {.name = "normals",
           .dimension = Dimension::choice,
           .documentation = "smooth: those of the surface that the facets stand for. facet: those of the "
                            "facets.",
           .default_text = "smooth",
           .choices = {"smooth", "facet"}},
          {.name = "step",
           .dimension = Dimension::length,
           .documentation = "Facets longer than this are looked at in several places. Without it half the "
                            "rule's limit, or 1/200 of the model's diagonal.",
           .default_text = {},
           .optional = true,
           .least = 1e-3,
           .greatest = 1e6},
          {.name = "greatest",
           .dimension = Dimension::length,
           .documentation = "No " + what +
                            " wider than this is looked for, which is faster; wider ones are "
                            "reported to be at least so wide.",
           .default_text = {},
           .optional = true,
           .least = 1e-3,
           .greatest = 1e6},
          {.name = "cone",
           .dimension = Dimension::angle,
           .documentation = "Of method ray: half angle of a search cone about the normal.",
           .default_text = "0 deg",
           .least = 0,
           .greatest = 80 * degree},
          {.name = "rays",
           .dimension = Dimension::count,
           .documentation = "How many rays the cone holds.",
           .default_text = "32",
           .least = 2,
           .greatest = 1000},
          {.name = "cone value",
           .dimension = Dimension::choice,
           .documentation = "What counts of the rays in the cone.",
           .default_text = "shortest",
           .choices = {"shortest", "mean"}}};
}

}  // namespace gabarit
