#include "model/load_step.h"

#include <numbers>
#include <regex>

#include <gmock/gmock.h>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include "model/brep_curvature.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

using step_shapes::loaded;
using step_shapes::replaced;
using step_shapes::text_of;
using step_shapes::volume;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
constexpr double pi = std::numbers::pi;

class LoadStep : public step_shapes::StepFiles {};

std::string error_of(const std::filesystem::path& file) {
  const Result<Model> model = load(file);
  return model ? "none" : model.error().front().message;
}

TEST_F(LoadStep, a_box_is_twelve_facets_on_six_planes) {
  const Model model = loaded(step(step_shapes::box(10, 20, 30)));
  EXPECT_EQ(model.mesh.facet_count(), 12U);
  EXPECT_EQ(model.mesh.vertices.size(), 8U);
  EXPECT_TRUE(watertight(model.defects));
  EXPECT_NEAR(volume(model), 6000, 1e-9);
  EXPECT_EQ(model.unit, Unit::mm);
  EXPECT_TRUE(model.unit_declared);
  EXPECT_THAT(model.format, HasSubstr("STEP"));
  EXPECT_THAT(model.warnings, IsEmpty());
  ASSERT_TRUE(model.brep);
  EXPECT_EQ(model.brep->faces.size(), 6U);
  EXPECT_EQ(model.brep->edges.size(), 12U);
  EXPECT_EQ(model.brep->vertices.size(), 8U);
  EXPECT_EQ(model.brep->facets.size(), 12U);
  for (const Edge& edge : model.brep->edges) {
    EXPECT_EQ(edge.kind, EdgeKind::convex);
    EXPECT_NEAR(edge.least_turn, pi / 2, 1e-9);
  }
}

// Facets inscribed in convex surfaces lose at most sag times area, and no more than what is missing is lost.
void expect_volume(const Model& model, double exact, double area) {
  EXPECT_TRUE(watertight(model.defects));
  EXPECT_NEAR(volume(model), exact, *model.sag * area);
}

TEST_F(LoadStep, curved_solids_are_watertight_and_lose_no_more_volume_than_the_sag_allows) {
  expect_volume(loaded(step(step_shapes::cylinder(10, 30))), pi * 100 * 30, 2 * pi * 10 * 30);
  expect_volume(loaded(step(step_shapes::tube(10, 8, 30))), pi * 36 * 30, 2 * pi * 18 * 30);
  expect_volume(loaded(step(step_shapes::sphere(10))), 4.0 / 3 * pi * 1000, 4 * pi * 100);
  expect_volume(loaded(step(step_shapes::torus(20, 5))), 2 * pi * pi * 20 * 25, 4 * pi * pi * 100);
  expect_volume(loaded(step(step_shapes::cone(10, 20))), pi * 2000 / 3, pi * 10 * std::sqrt(500.0));
  const double x = 40 - 8, y = 30 - 8, z = 20 - 8, r = 4;  // Steiner: the inner box swept by a ball
  expect_volume(
      loaded(step(step_shapes::rounded_box(40, 30, 20, 4))),
      x * y * z + 2 * r * (x * y + y * z + z * x) + pi * r * r * (x + y + z) + 4.0 / 3 * pi * r * r * r,
      2 * pi * r * (x + y + z) + 4 * pi * r * r);
}

TEST_F(LoadStep, the_sag_is_what_was_asked_for_or_better_and_finer_facets_follow_from_less) {
  const auto file = step(step_shapes::sphere(10));
  const Model coarse = loaded(file, {.sag = 0.5});
  const Model fine = loaded(file, {.sag = 0.005});
  EXPECT_LE(*coarse.sag, 0.5);
  EXPECT_LE(*fine.sag, 0.005);
  EXPECT_GT(*fine.sag, 1e-4);
  EXPECT_GT(fine.mesh.facet_count(), 4 * coarse.mesh.facet_count());
  // No point of a facet is deeper inside the ball than the sag says; chords reach deepest at their middles.
  for (const Model* model : {&coarse, &fine}) {
    double deepest = 0;
    for (FacetId f = 0; f < model->mesh.facet_count(); ++f) {
      for (int i = 0; i < 3; ++i)
        deepest = std::max(
            deepest, 10 - length((model->mesh.corner(f, i) + model->mesh.corner(f, (i + 1) % 3)) / 2.0));
      deepest = std::max(deepest, 10 - length(model->mesh.centroid(f)));
    }
    EXPECT_LE(deepest, *model->sag);
    EXPECT_GT(deepest, *model->sag / 3);
  }
}

TEST_F(LoadStep, every_corner_of_a_facet_lies_on_its_face_at_its_parameters) {
  const Model model = loaded(step(step_shapes::rounded_box(40, 30, 20, 4)));
  const BrepView brep = view(*model.brep);
  for (FacetId f = 0; f < model.mesh.facet_count(); ++f) {
    const FacetOrigin& origin = model.brep->facets[f];
    for (int i = 0; i < 3; ++i) {
      const Vec3d p =
          face_point(brep, model.brep->faces[origin.face], origin.corners[static_cast<std::size_t>(i)]).p;
      EXPECT_LT(length(p - model.mesh.corner(f, i)), 1e-6);
    }
  }
}

TEST_F(LoadStep, facets_face_as_the_outward_normal_of_their_face) {
  for (const TopoDS_Shape& shape : {step_shapes::tube(10, 8, 30), step_shapes::rounded_box(40, 30, 20, 4)}) {
    const Model model = loaded(step(shape));
    const BrepView brep = view(*model.brep);
    for (FacetId f = 0; f < model.mesh.facet_count(); ++f) {
      const FacetOrigin& origin = model.brep->facets[f];
      const Face& face = model.brep->faces[origin.face];
      const Vec3d n =
          outward_normal(face_point(brep, face, parameters_at(origin, 1 / 3., 1 / 3., 1 / 3.)), face.sign);
      EXPECT_GT(dot(n, facet_normal(model.mesh, f)), 0.9);
    }
  }
}

TEST_F(LoadStep, a_file_in_inches_or_metres_is_read_in_millimetres) {
  const Model inches = loaded(step(step_shapes::box(25.4, 50.8, 76.2), "INCH"));
  EXPECT_EQ(inches.unit, Unit::in);
  EXPECT_NEAR(inches.box.max.z, 76.2, 1e-9);
  const Model metres = loaded(step(step_shapes::box(100, 200, 300), "M"));
  EXPECT_EQ(metres.unit, Unit::m);
  EXPECT_NEAR(metres.box.max.z, 300, 1e-9);
}

TEST_F(LoadStep, a_unit_given_by_the_user_does_not_outdo_the_file) {
  const Model model = loaded(step(step_shapes::box(10, 20, 30)), {.unit = Unit::m});
  EXPECT_NEAR(model.box.max.z, 30, 1e-9);
  ASSERT_EQ(model.warnings.size(), 1U);
  EXPECT_THAT(model.warnings[0].message, HasSubstr("--units m is ignored"));
}

TEST_F(LoadStep, an_assembly_gives_named_placed_bodies_and_every_instance_is_one) {
  const TopoDS_Shape bolt = step_shapes::cylinder(2, 10);
  const Model model =
      loaded(assembly({{"plate", step_shapes::box(50, 50, 5)},
                       {"Schraube größer", step_shapes::moved(bolt, 10, 10, 5)},
                       {"Schraube größer", step_shapes::moved(step_shapes::turned(bolt, 90), 40, 40, 30)}}));
  EXPECT_THAT(model.bodies, ElementsAre("plate", "Schraube größer", "Schraube größer"));
  EXPECT_NEAR(volume(model), 12500 + 2 * pi * 40, 2 * *model.sag * 2 * pi * 20);
  EXPECT_TRUE(watertight(model.defects));
  EXPECT_NEAR(model.box.max.z, 32, 0.01);
  EXPECT_EQ(model.mesh.body.front(), 0U);
  EXPECT_EQ(model.mesh.body.back(), 2U);
}

TEST_F(LoadStep, placements_of_nested_assemblies_follow_one_another) {
  gp_Trsf along, turned;
  along.SetTranslation(gp_Vec(100, 0, 0));
  turned.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), pi / 2);
  const Model model = loaded(nested({{"plate", step_shapes::box(50, 20, 5)},
                                     {"block", step_shapes::moved(step_shapes::box(4, 4, 4), 10, 0, 5)}},
                                    along, turned));
  EXPECT_THAT(model.bodies, ElementsAre("plate", "block", "plate", "block"));
  EXPECT_TRUE(watertight(model.defects));
  EXPECT_NEAR(volume(model), 2 * (5000 + 64), 1e-6);
  std::vector<Box3d> boxes(4);
  for (FacetId f = 0; f < model.mesh.facet_count(); ++f)
    for (int i = 0; i < 3; ++i) boxes[model.mesh.body_of(f)].add(model.mesh.corner(f, i));
  EXPECT_LT(length(boxes[0].min - Vec3d{100, 0, 0}), 1e-9);
  EXPECT_LT(length(boxes[1].max - Vec3d{114, 4, 9}), 1e-9);
  EXPECT_LT(length(boxes[2].max - Vec3d{0, 50, 5}), 1e-9);
  EXPECT_LT(length(boxes[3].min - Vec3d{-4, 10, 5}), 1e-9);
}

TEST_F(LoadStep, solids_of_one_product_are_told_apart_by_their_own_names_where_they_have_any) {
  const TopoDS_Shape two = step_shapes::together(
      {step_shapes::box(10, 10, 10), step_shapes::moved(step_shapes::box(5, 5, 5), 20, 0, 0)});
  std::string content = text_of(one_product(two));
  content = std::regex_replace(content, std::regex("'Open CASCADE STEP translator [0-9. ]+'"), "'pair'");
  EXPECT_THAT(loaded(text("unnamed.stp", content)).bodies, ElementsAre("pair", "pair"));
  const std::string named = replaced(content, "MANIFOLD_SOLID_BREP(''",
                                     {"MANIFOLD_SOLID_BREP('left'", "MANIFOLD_SOLID_BREP('right'"});
  EXPECT_THAT(loaded(text("named.stp", named)).bodies, ElementsAre("pair/left", "pair/right"));
}

TEST_F(LoadStep, solids_that_touch_share_no_vertices) {
  const Model model = loaded(assembly({{"one", step_shapes::box(10, 10, 10)},
                                       {"two", step_shapes::moved(step_shapes::box(10, 10, 10), 10, 0, 0)}}));
  EXPECT_EQ(model.mesh.vertices.size(), 16U);
  EXPECT_TRUE(watertight(model.defects));
}

TEST_F(LoadStep, an_open_shell_is_read_and_said_to_be_one) {
  const Model model = loaded(step(step_shapes::without_a_face(step_shapes::box(10, 20, 30))));
  EXPECT_EQ(model.mesh.facet_count(), 10U);
  EXPECT_EQ(model.defects.open_edges, 4U);
  ASSERT_EQ(model.warnings.size(), 1U);
  EXPECT_THAT(model.warnings[0].message, HasSubstr("open surfaces"));
}

TEST_F(LoadStep, the_content_counts_whatever_the_name_says) {
  const std::string content = text_of(step(step_shapes::box(10, 20, 30)));
  EXPECT_EQ(loaded(text("PART.STP", content)).mesh.facet_count(), 12U);
  EXPECT_EQ(loaded(text("part.p21", content)).mesh.facet_count(), 12U);
  EXPECT_EQ(loaded(text("part", content)).mesh.facet_count(), 12U);
  const Model misnamed = loaded(text("part.stl", content));
  EXPECT_EQ(misnamed.mesh.facet_count(), 12U);
  EXPECT_THAT(misnamed.warnings.at(0).message, HasSubstr("that of a .step file"));
}

TEST_F(LoadStep, empty_and_cut_off_files_are_refused) {
  const std::string content = text_of(step(step_shapes::rounded_box(40, 30, 20, 4)));
  EXPECT_EQ(error_of(text("empty.step", "")), "is empty; export it again");
  EXPECT_THAT(error_of(text("words.step", "hello")), HasSubstr("it is no STEP file"));
  EXPECT_THAT(error_of(text("half.step", content.substr(0, content.size() / 2))), HasSubstr("cut off"));
  EXPECT_THAT(error_of(text("start.step", content.substr(0, 40))), HasSubstr("no DATA section"));
  EXPECT_THAT(
      error_of(
          text("hollow.step",
               "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
               "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n")),
      HasSubstr("holds no solid"));
}

TEST_F(LoadStep, bodies_of_facets_alone_are_never_left_out_without_a_word) {
  const std::string facets =
      "#9001=TESSELLATED_SOLID('it''s, (one',(#9002,#9003),$);\n#9004=TESSELLATED_SHELL ('',(#9002),$);\n"
      "#9005=TESSELLATED_SOLID('the box once more',(#9002),#15);\n";
  const std::string content = text_of(step(step_shapes::box(10, 20, 30)));
  std::string both = content;
  both.insert(both.rfind("ENDSEC;"), facets);
  const Model model = loaded(text("both.step", both));
  EXPECT_EQ(model.mesh.facet_count(), 12U);
  ASSERT_FALSE(model.warnings.empty());
  EXPECT_THAT(model.warnings.front().message, HasSubstr("holds 2 bodies or shells as facets"));
  std::string alone = content.substr(0, content.find("DATA;") + 5) + "\n" + facets;
  alone += "ENDSEC;\nEND-ISO-10303-21;\n";
  EXPECT_THAT(error_of(text("alone.step", alone)), HasSubstr("holds 2 bodies or shells as facets"));
}

TEST_F(LoadStep, a_file_with_its_middle_missing_is_refused_or_warned_about_and_never_a_crash) {
  const std::string content = text_of(step(step_shapes::rounded_box(40, 30, 20, 4)));
  for (int part = 1; part < 10; ++part) {
    std::string broken = content;
    broken.erase(content.size() / 10 * static_cast<std::size_t>(part), content.size() / 10);
    const Result<Model> model = load(text("broken.step", broken));
    EXPECT_TRUE(!model || !watertight(model->defects) || !model->warnings.empty()) << "tenth " << part;
  }
}

TEST_F(LoadStep, a_reader_that_has_no_time_says_so) {
  const Result<Model> model = load(step(step_shapes::box(10, 20, 30)), {.time_limit = 0});
  ASSERT_FALSE(model);
  EXPECT_THAT(model.error().front().message, HasSubstr("not read within"));
}

TEST_F(LoadStep, one_thread_and_many_give_the_same_facets) {
  const auto file = step(step_shapes::rounded_box(40, 30, 20, 4));
  const Model one = loaded(file, {.threads = 1}), many = loaded(file, {.threads = 4});
  EXPECT_EQ(one.mesh.vertices, many.mesh.vertices);
  EXPECT_EQ(one.mesh.facets, many.mesh.facets);
  EXPECT_EQ(one.sag, many.sag);
}

TEST_F(LoadStep, nothing_is_printed) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  loaded(step(step_shapes::box(10, 20, 30)));
  static_cast<void>(load(text("broken.step", "ISO-10303-21;\nDATA;\n#1=(;\nEND-ISO-10303-21;\n")));
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
}

TEST_F(LoadStep, iges_faces_are_sewn_into_a_solid) {
  const Model model = loaded(iges(step_shapes::box(25.4, 50.8, 76.2), "IN"));
  EXPECT_EQ(model.format, "IGES");
  EXPECT_EQ(model.unit, Unit::in);
  EXPECT_TRUE(watertight(model.defects));
  EXPECT_NEAR(volume(model), 25.4 * 50.8 * 76.2, 1e-6);
  const Model tube = loaded(iges(step_shapes::tube(10, 8, 30)));
  EXPECT_TRUE(watertight(tube.defects));
  EXPECT_NEAR(volume(tube), pi * 36 * 30, *tube.sag * 2 * pi * 18 * 30);
}

TEST_F(LoadStep, iges_files_that_are_none_or_cut_off_are_refused) {
  const std::string content = text_of(iges(step_shapes::box(10, 20, 30)));
  EXPECT_THAT(error_of(text("half.igs", content.substr(0, content.size() / 2))), HasSubstr("cut off"));
  EXPECT_THAT(error_of(text("words.iges", "hello")), HasSubstr("no IGES file"));
}

}  // namespace
}  // namespace gabarit
