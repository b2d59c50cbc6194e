#include "checks/thickness.h"

#include "checks/wall_measure.h"

namespace gabarit {
namespace {

Field measure(const Scene& scene, const Setup& setup, const Region& region, const Arguments& arguments) {
  return measure_walls(Side::inside, scene, setup, region, arguments);
}

std::string sentence(const Arguments& arguments) {
  return "thickness of the material (" + method_text(arguments) + ")";
}

}  // namespace

const Measure thickness_measure{
    .name = "thickness",
    .summary = "How thick the material is at a facet: the diameter of a ball inside the part.",
    .documentation =
        "Of all balls inside the part that touch the surface at a point, the largest one that a second "
        "surface stops gives the thickness there: its diameter. A second surface counts when its normal "
        "turns away from the point's by at least the separation angle. On reflex edges and vertices (the "
        "root of a rib, the tip of a groove) the direction from the ball's centre stands for the normal.\n\n"
        "wall, the default, takes 120 deg: opposite walls only. A box with sharp edges is as thick as its "
        "walls, and wedges and feather edges sharper than 60 deg are still found. sphere takes 20 deg: near "
        "every sharp edge the ball, and so the value, goes to zero; right for thick spots (at most), "
        "useless for thin walls. ray measures along the normal alone, or the shortest or mean of a cone of "
        "rays; it is blind to what lies beside the rays.\n\n"
        "The paper counts every facet that the ball reaches, whatever its normal, with the facets' own "
        "normals: separation 0 deg, normals facet. Then a curved surface stops its own ball (a cylinder of "
        "split quads reads a third too thin at every resolution), and every sharp edge is thin. Here the "
        "smallest ball is found in one search instead of by shrinking: inversion about the point turns it "
        "into a linear maximum with a closed form for every facet.\n\n"
        "A facet larger than the step is looked at in several places and counts with its smallest value "
        "(for a limit from above, its greatest). Bounds allow for the sag of the facets near the point and "
        "near the contact, for the turn of the normals within a facet and for what lies between the places "
        "looked at; flat walls have none. For a limit from above the greatest value between the places is a "
        "bound while the ball keeps its contact with a facet; where it rolls over a reflex edge it is an "
        "estimate.\n\n"
        "Where a ray along the normal leaves by a gap of the mesh or meets a flipped facet, the facet is "
        "open: "
        "undecided, never a number. A gap beside the ray is not noticed, nor is one beside the rays of "
        "method "
        "ray. In a closed mesh a ball that nothing stops has no wall opposite: without limit, and undecided "
        "for a limit from above. Thin facets that lie inside the part, where the mesh overlaps itself, bound "
        "no wall and have no value; other bodies that overlap are measured as they overlap.\n\n"
        "Models that have exact surfaces (STEP, IGES) are measured between these, by Newton's method on the "
        "trimmed faces and edges; the facets only say where to look, and give the lower bound of what lies "
        "between the places looked at. Values are then multiples of 1e-6 mm, and the thinnest places are "
        "followed over the surface; not those of rays from beside an edge sharper than a right angle, which "
        "get shorter without end towards it. Balls: cells that are clear of the limit, whatever the normals "
        "of "
        "the surfaces, are cut to eight steps only. normals facet measures the facets all the same.\n\n"
        "Limits: the facets are taken as they are, not the surface that they once approximated beyond its "
        "sag; a fold or burr of the mesh is as thin as it is, however small; where thousands of contacts "
        "nearly tie (the inside of a ball) the value can be up to 1 % too large, and the lower bound says "
        "so.\n\n"
        "Source: M. Inui, N. Umezu, R. Shimane, Shrinking sphere: A parallel algorithm for computing the "
        "thickness of 3D objects, Computer-Aided Design and Applications 13, 2016. Exact "
        "surfaces: after G. Lemasson et al., Accurate thickness computation of a B-Rep "
        "model on the GPU, WSCG 2014.",
    .symbol = "t",
    .dimension = Dimension::length,
    .parameters = wall_parameters(Side::inside),
    .measure = measure,
    .varies_within_facets = true,
    .sentence = sentence};

}  // namespace gabarit
