#include "checks/radius.h"

#include "checks/radius_exact.h"
#include "checks/sphere_placement.h"
#include "checks/turning.h"

namespace gabarit {

namespace {

Field measure(const Scene& scene, const Setup& setup, const Region& region, const Arguments& arguments) {
  if (arguments.text("method") == "sphere placement") return measure_sphere_placement(scene, setup, region);
  return scene.model().brep ? measure_exact_radius(scene, region) : measure_turning(scene, setup, region);
}

std::string sentence(const Arguments& arguments) {
  return "the radius of convex rounding, by " + arguments.text("method");
}

}  // namespace

const Measure radius_measure{
    .name = "radius",
    .summary = "The radius of convex rounding: 0 for a sharp edge, infinite for a plane or a hollow.",
    .documentation =
        "The smallest radius of convex curvature of the surface at a facet. Planes and hollows have "
        "an infinite radius, an edge with a jump of the normal has radius 0.\n\n"
        "A model with exact surfaces (STEP, IGES) is measured on them, unless the method is `sphere "
        "placement`: the radius is that of the sharpest point of a face within the facet, from the "
        "kind of the surface where it has one; an edge is sharp, radius 0, where the normals of its "
        "two faces turn away from each other by more than 5 deg, and smooth below. Radii are rounded "
        "to 1e-6 mm, so that a rounding of R4 is R4; lower and upper bound equal the value, but where the "
        "curvature of a spline, an extrusion or a revolution varies: there the value is that of the sharpest "
        "place found, and the lower bound is proven for the whole facet, mostly within 0.1 % (docs/radius.md "
        "says how).\n\n"
        "`turning` fits one curvature to the angles at the edges of a facet and of its neighbours. "
        "Where the corners of a mesh lie on the surface, the angle at an edge is known from the "
        "curvature and the shape of the two facets, whatever that shape is: long strips and irregular "
        "triangles read the same radius, on roundings of one radius to within 2.5 %. What lies beyond "
        "the rim of a rounding is a plane of its own. The bounds hold the part by which the edges "
        "disagree.\n\n"
        "An edge that no rounding beside it explains is sharp or blunt: its radius is at most what "
        "can hide between the facets and the true surface, s / (1 - cos(turn / 2)) for a sag of s "
        "between large facets, and at least 0. With a sag of 0.1 mm an edge of more than 25.7 deg is "
        "a certain violation of R4. What turns less, in a single strip of facets, is undecided: a "
        "rounding and a blunt edge look the same.\n\n"
        "Limits: the corners of the mesh have to lie on the true surface, as those of CAD exports do; "
        "scanned or smoothed meshes read too sharp or undecided. The sag has to be true: an edge of a "
        "coarser mesh is taken for sharp. At the free edge of an open mesh, where facets disagree "
        "about the outside and on bodies that are inside out the lower bound is 0. Only the edges "
        "that the region selects are looked at for sharpness.\n\n"
        "`sphere placement` is the method of the source: the largest ball that touches the facet from "
        "inside at its centroid and meets no facet beside it. The paper asks whether a ball of R4 "
        "fits, this gives the radius at which the answer changes. Its bounds are those of the "
        "definition, not of the true surface. Known weakness: on the usual strips of split "
        "quadrilaterals it reads two thirds of the true radius at every resolution, so that a "
        "rounding of R5.9 fails R4; and it misses a sharp edge between facets that are large beside "
        "the limit (40 x 20 mm at 90 deg reads 6.7 mm).\n\n"
        "Source: Inui and Umezu, Extraction of Vertical Cylinder Contacting Area for Motorcycle "
        "Safety Verification, Computer-Aided Design and Applications (sphere placement); "
        "docs/radius.md (turning).",
    .symbol = "R",
    .dimension = Dimension::length,
    .parameters = {{.name = "method",
                    .dimension = Dimension::choice,
                    .documentation = "How the radius is found.",
                    .default_text = "turning",
                    .choices = {"turning", "sphere placement"}}},
    .measure = measure,
    .sentence = sentence};

}  // namespace gabarit
