#include "checks/facing.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace gabarit {

namespace {

constexpr double slack = 1e-6;  // rad: what the rounding of coordinates to float does to an exact side wall

Vec3d named_direction(const Frame& frame, const std::string& name) {
  if (name == "forward") return frame.forward;
  if (name == "rear") return -frame.forward;
  if (name == "up") return frame.up;
  if (name == "down") return -frame.up;
  return name == "left" ? frame.left() : -frame.left();
}

Vec3d direction_of(const Frame& frame, const Value& value) {
  if (const auto* name = std::get_if<std::string>(&value)) return named_direction(frame, *name);
  return normalized(std::get<Vec3d>(value));
}

Region select_facing(const Scene& scene, const Setup& setup, const Arguments& arguments) {
  const TriangleMesh& mesh = scene.mesh();
  const Vec3d direction = direction_of(setup.frame, arguments.all().at("direction"));
  const double within = arguments.number("within");
  const bool any_angle = within >= std::numbers::pi - slack;
  Region region;
  region.facets.reserve(mesh.facet_count());
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const Vec3d normal = facet_normal(mesh, f);
    const double angle = std::atan2(length(cross(normal, direction)), dot(normal, direction));
    region.facets.push_back(normal == Vec3d{}                     ? Selected::maybe
                            : any_angle || angle < within - slack ? Selected::yes
                                                                  : Selected::no);
  }
  return region;
}

std::string sentence(const Arguments& arguments) {
  const Value& value = arguments.all().at("direction");
  const auto* name = std::get_if<std::string>(&value);
  const Vec3d* v = std::get_if<Vec3d>(&value);
  const double degrees = std::round(arguments.number("within") * 180.0 / std::numbers::pi * 1e6) / 1e6;
  return fmt::format("it faces {} (by less than {}°)",
                     name ? *name : fmt::format("({}, {}, {})", v->x, v->y, v->z), degrees);
}

}  // namespace

const Selector facing_selector{
    .name = "facing",
    .summary = "Facets whose outward normal points towards a direction.",
    .documentation =
        "A facet is selected when the angle between its outward normal and the direction is less than "
        "`within`, by "
        "more than 1e-6 rad. With the default of 90 deg a side wall that is exactly parallel to the "
        "direction does "
        "not face it, whatever the rounding of its coordinates; `not: {facing: rear}` therefore keeps the "
        "side walls. "
        "180 deg selects every facet that has a normal.\n\n"
        "The named directions follow the rule file's frame (left and right as seen by the driver); a vector "
        "is in "
        "the model's coordinates. A facet without a normal is only maybe selected.",
    .parameters = {{.name = "direction",
                    .dimension = Dimension::direction,
                    .documentation = "A name, or a vector in the model's coordinates such as [0, 0, 1].",
                    .choices = {"forward", "rear", "up", "down", "left", "right"}},
                   {.name = "within",
                    .dimension = Dimension::angle,
                    .documentation = "The angle that the normal may be away from the direction.",
                    .default_text = "90 deg",
                    .least = 0.01 * std::numbers::pi / 180.0,
                    .greatest = std::numbers::pi}},
    .select = select_facing,
    .sentence = sentence};

}  // namespace gabarit
