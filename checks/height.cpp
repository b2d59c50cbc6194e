#include "checks/height.h"

#include <cmath>

#include <fmt/format.h>

namespace gabarit {

namespace {

Interval band(const Arguments& arguments) {
  Interval result;
  if (arguments.has("from")) result.from = arguments.number("from");
  if (arguments.has("to")) result.to = arguments.number("to");
  return result;
}

// Of two or three heights: a facet and an edge are convex, so they meet the band exactly when their range
// does.
Selected reaches(const Interval& band, std::initializer_list<double> heights) {
  for (const double h : heights) {
    if (!std::isfinite(h)) return Selected::maybe;  // nobody can say where it lies
  }
  return std::max(heights) >= band.from && std::min(heights) <= band.to ? Selected::yes : Selected::no;
}

Region select_height(const Scene& scene, const Setup& setup, const Arguments& arguments) {
  const TriangleMesh& mesh = scene.mesh();
  const Interval allowed = band(arguments);
  std::vector<double> height(mesh.vertices.size());
  for (std::size_t v = 0; v < height.size(); ++v) height[v] = setup.frame.height(mesh.vertices[v]);
  Region region;
  region.facets.reserve(mesh.facet_count());
  region.edges.reserve(mesh.facet_count());
  for (const auto& [a, b, c] : mesh.facets) {
    region.facets.push_back(reaches(allowed, {height[a], height[b], height[c]}));
    region.edges.push_back({reaches(allowed, {height[a], height[b]}),
                            reaches(allowed, {height[b], height[c]}),
                            reaches(allowed, {height[c], height[a]})});
  }
  return region;
}

std::string sentence(const Arguments& arguments) {
  const Interval limits = band(arguments);
  if (!arguments.has("to")) return fmt::format("it reaches above {} mm above ground", limits.from);
  if (!arguments.has("from")) return fmt::format("it reaches below {} mm above ground", limits.to);
  return fmt::format("it reaches between {} mm and {} mm above ground", limits.from, limits.to);
}

}  // namespace

const Selector height_selector{
    .name = "height",
    .summary = "Facets that reach into a band of heights above ground.",
    .documentation =
        "A facet is selected when any part of it lies in the band, its ends included; an edge likewise. "
        "Heights "
        "count along `up` from the ground of the rule file's frame.\n\n"
        "Beside a contact in the same `all` the band also says how far the probe reaches: the model is "
        "clipped to "
        "it before the probe is moved. What only touches the band from outside is selected too: the rule "
        "looks at a "
        "little more rather than less.\n\n"
        "A facet with coordinates that are not finite is only maybe selected.",
    .parameters = {{.name = "from",
                    .dimension = Dimension::length,
                    .documentation = "Lower end; without it the band reaches down without end.",
                    .optional = true},
                   {.name = "to",
                    .dimension = Dimension::length,
                    .documentation = "Upper end; without it the band reaches up without end.",
                    .optional = true}},
    .select = select_height,
    .height_band = band,
    .sentence = sentence};

}  // namespace gabarit
