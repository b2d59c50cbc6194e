#include <numeric>
#include <random>

#include "checks/facet_domain.h"
#include "model/brep_trim.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

class FacetDomains : public step_shapes::StepFiles {};

struct Domains {
  std::vector<FacetDomain> of;
  explicit Domains(const Model& model) {
    std::vector<HalfEdgeId> other(3 * model.mesh.facet_count());
    std::iota(other.begin(), other.end(), HalfEdgeId{0});
    EdgeTable(model.mesh).for_each_edge([&](std::span<const HalfEdgeId> edge) {
      if (edge.size() == 2) other[edge[0]] = edge[1], other[edge[1]] = edge[0];
    });
    for (FacetId f = 0; f < model.mesh.facet_count(); ++f)
      of.push_back(facet_domain(*model.brep, f, {other[3 * f], other[3 * f + 1], other[3 * f + 2]}));
  }
};

// How many of the random places of the faces lie in no facet's domain, and in no facet's triangle.
struct Missed {
  int by_domains = 0, by_triangles = 0, looked_at = 0;
};
Missed missed(const Model& model) {
  const Brep& brep = *model.brep;
  const BrepView arrays = view(brep);
  const Domains domains(model);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> in(0, 1);
  Missed result;
  for (FaceId face = 0; face < brep.faces.size(); ++face) {
    const ParameterBox& r = brep.faces[face].range;
    for (int i = 0; i < 2000; ++i) {
      const Parameters p{r.u0 + in(random) * (r.u1 - r.u0), r.v0 + in(random) * (r.v1 - r.v0)};
      if (trim_side(arrays, face, p) == TrimSide::outside) continue;
      ++result.looked_at;
      bool in_domain = false, in_facet = false;
      for (FacetId f = 0; f < brep.facets.size(); ++f) {
        if (brep.facets[f].face != face) continue;
        const ParameterBox& b = domains.of[f].box;
        const bool in_box = p.u >= b.u0 && p.u <= b.u1 && p.v >= b.v0 && p.v <= b.v1;
        in_facet = in_facet || in_triangle(brep.facets[f], p);
        in_domain =
            in_domain || (in_box && !part_in(brep.facets[f], domains.of[f], {p.u, p.u, p.v, p.v}).empty());
      }
      result.by_domains += in_domain ? 0 : 1;
      result.by_triangles += in_facet ? 0 : 1;
    }
  }
  return result;
}

TEST_F(FacetDomains, together_cover_faces_with_curved_rims_where_the_triangles_do_not) {
  LoadOptions coarse;
  coarse.sag = 0.8;
  const TopoDS_Shape bored = step_shapes::minus(
      step_shapes::lobed_cylinder({10, 9, 10, 9, 10, 9}, 20),
      step_shapes::moved(step_shapes::turned(step_shapes::cylinder(4, 60), 90), 0, 30, 10));
  for (const TopoDS_Shape& shape : {bored, step_shapes::turned(bored, 40), step_shapes::as_splines(bored)}) {
    const Missed result = missed(step_shapes::loaded(step(shape), coarse));
    EXPECT_EQ(result.by_domains, 0) << "of " << result.looked_at;
    EXPECT_GT(result.by_triangles, 0);
  }
}

TEST_F(FacetDomains, a_facet_inside_a_face_stands_for_its_triangle_alone) {
  const Model model = step_shapes::loaded(step(step_shapes::torus(20, 5)));
  const Domains domains(model);
  for (FacetId f = 0; f < model.mesh.facet_count(); ++f) {
    const auto& c = model.brep->facets[f].corners;
    const auto [u0, u1] = std::minmax({c[0].u, c[1].u, c[2].u});
    EXPECT_EQ(domains.of[f].box.u0, u0);
    EXPECT_EQ(domains.of[f].box.u1, u1);
    EXPECT_TRUE(domains.of[f].straight[0] && domains.of[f].straight[1] && domains.of[f].straight[2]);
  }
}

}  // namespace
}  // namespace gabarit
