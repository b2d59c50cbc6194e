#include <regex>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/step_shapes.h"

namespace gabarit {
namespace {

using step_shapes::loaded;
using step_shapes::replaced;
using step_shapes::text_of;

class OcctNames : public step_shapes::StepFiles {};

// The number of the first entity of a type, with its #; what follows `from` only.
std::string entity(const std::string& content, const std::string& type, std::size_t skip = 0) {
  std::smatch found;
  auto begin = content.begin();
  for (std::size_t i = 0; i <= skip; ++i) {
    if (!std::regex_search(begin, content.end(), found, std::regex("(#[0-9]+) *= *" + type + "\\(")))
      return "#0";
    begin = found[0].second;
  }
  return found[1];
}

// A style that gives an entity a colour; `number` and the seven after it must be free.
std::string style(int number, const std::string& item, const std::string& colour,
                  const std::string& type = "STYLED_ITEM", const std::string& more = "") {
  constexpr auto chain =
      "#{0}={8}('',(#{1}),{9}{10});\n#{1}=PRESENTATION_STYLE_ASSIGNMENT((#{2}));\n"
      "#{2}=SURFACE_STYLE_USAGE(.BOTH.,#{3});\n#{3}=SURFACE_SIDE_STYLE('',(#{4}));\n"
      "#{4}=SURFACE_STYLE_FILL_AREA(#{5});\n#{5}=FILL_AREA_STYLE('',(#{6}));\n"
      "#{6}=FILL_AREA_STYLE_COLOUR('',#{7});\n#{7}={11};\n";
  return fmt::format(chain, number, number + 1, number + 2, number + 3, number + 4, number + 5, number + 6,
                     number + 7, type, item, more, colour);
}

constexpr Colour red{255, 0, 0}, grey{128, 128, 128}, orange{255, 128, 0};

TEST_F(OcctNames, faces_keep_their_names_and_their_colour_or_else_that_of_their_solid) {
  std::string content = text_of(step(step_shapes::box(10, 20, 30)));
  content = replaced(content, "ADVANCED_FACE(''", {"ADVANCED_FACE('Boden'", "ADVANCED_FACE('NONE'"});
  const std::string first = entity(content, "ADVANCED_FACE"), second = entity(content, "ADVANCED_FACE", 1);
  const std::string styles =
      style(9000, entity(content, "MANIFOLD_SOLID_BREP"), "COLOUR_RGB('',0.5,0.5,0.5)") +
      style(9010, first, "DRAUGHTING_PRE_DEFINED_COLOUR('red')") +
      style(9020, second, "COLOUR_RGB('',0.,0.,1.)") +
      style(9030, second, "COLOUR_RGB('',7.,0.5,-1.)", "OVER_RIDING_STYLED_ITEM", ",#9020");
  content.insert(content.rfind("ENDSEC;"), styles);
  const Model model = loaded(text("painted.step", content));
  ASSERT_EQ(model.brep->labels.size(), 6U);
  EXPECT_EQ(model.brep->labels[0].name, "Boden");
  EXPECT_EQ(model.brep->labels[1].name, "");
  EXPECT_EQ(model.brep->labels[0].colour, red);
  EXPECT_EQ(model.brep->labels[1].colour, orange);
  for (std::size_t i = 2; i < 6; ++i) EXPECT_EQ(model.brep->labels[i].colour, grey);
}

TEST_F(OcctNames, a_file_without_colours_and_face_names_has_none) {
  const Model model = loaded(step(step_shapes::tube(10, 8, 30)));
  for (const FaceLabel& label : model.brep->labels) {
    EXPECT_EQ(label.name, "");
    EXPECT_FALSE(label.colour);
  }
}

TEST_F(OcctNames, iges_faces_keep_their_colours_when_they_are_sewn) {
  const Model model = loaded(painted_iges(step_shapes::box(10, 20, 30)));
  ASSERT_EQ(model.brep->labels.size(), 6U);
  EXPECT_TRUE(watertight(model.defects));
  std::size_t reds = 0, oranges = 0;
  for (const FaceLabel& label : model.brep->labels) {
    reds += label.colour == red ? 1 : 0;
    oranges += label.colour == orange ? 1 : 0;
  }
  EXPECT_EQ(reds, 3U);
  EXPECT_EQ(oranges, 3U);
}

}  // namespace
}  // namespace gabarit
