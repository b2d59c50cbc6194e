#include "checks/clearance.h"

#include "checks/wall_measure.h"

namespace gabarit {
namespace {

Field measure(const Scene& scene, const Setup& setup, const Region& region, const Arguments& arguments) {
  return measure_walls(Side::outside, scene, setup, region, arguments);
}

std::string sentence(const Arguments& arguments) {
  return "width of the gap in front (" + method_text(arguments) + ")";
}

}  // namespace

const Measure clearance_measure{
    .name = "clearance",
    .summary = "How wide the gap or slot in front of a facet is: the diameter of a ball outside the part.",
    .documentation =
        "The same measure as thickness, on the other side of the surface: the largest ball outside the part "
        "that touches the facet and that a second surface stops, its own body's or another's. Methods, "
        "separation angle, normals and bounds are those of thickness, and models that have exact surfaces "
        "are "
        "measured between these; sharp edges take the place of reflex "
        "ones.\n\n"
        "In front of most of a part there is nothing: the clearance is infinite there. It passes a limit "
        "from below and fails one from above. Bodies in contact have no gap between them: what lies within "
        "a millionth of the model's size is not seen as one.",
    .symbol = "c",
    .dimension = Dimension::length,
    .parameters = wall_parameters(Side::outside),
    .measure = measure,
    .varies_within_facets = true,
    .sentence = sentence};

}  // namespace gabarit
