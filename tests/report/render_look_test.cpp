// What a picture says: small failing facets stay visible, outlines, emphasis, lines.
#include <cmath>

#include <gmock/gmock.h>

#include "report/palette.h"
#include "tests/report/picture_checks.h"

namespace gabarit {
namespace {

const Device one = Device::cpu(1);
const shapes::Triangles plate = shapes::box({-50, -50, -2}, {50, 50, 0});

// The plate with one more facet, which fails.
struct PlateWithFailure {
  TriangleMesh mesh;
  std::vector<Rgb> colours;
  std::vector<std::uint8_t> marked, emphasis;

  explicit PlateWithFailure(const shapes::Triangle& failing, bool first = false)
      : mesh(shapes::mesh(first ? shapes::joined({failing}, plate) : shapes::joined(plate, {failing}))),
        colours(13, palette::out_of_reach),
        marked(13),
        emphasis(13) {
    const std::size_t f = first ? 0 : 12;
    colours[f] = palette::fail;
    marked[f] = 2;
    emphasis[f] = 1;
  }

  Drawing drawing() const {
    Drawing d;
    d.mesh = &mesh;
    d.facet_colours = colours;
    return d;
  }
  Picture picture(bool keep_visible) const {
    Drawing d = drawing();
    if (keep_visible) d.marked = marked;
    return render(d, from_above(120), 120, 120, one);
  }
};

shapes::Triangle speck(double x, double y, double z, double size) {
  return {Vec3d{x, y, z}, Vec3d{x + size, y, z}, Vec3d{x, y + size, z}};
}

TEST(marked_facets, smaller_than_a_pixel_show_as_a_dot) {
  for (const double size : {1e-9, 1e-3, 0.05}) {
    const PlateWithFailure scene(speck(10.13, -7.31, 1e-6, size));
    EXPECT_EQ(count_reddish(scene.picture(false)), 0) << size;
    const int pixels = count_reddish(scene.picture(true));
    EXPECT_GE(pixels, 3) << size;
    EXPECT_LE(pixels, 9) << size;
  }
}

TEST(marked_facets, show_as_a_dot_where_they_are_even_across_tiles) {
  for (double x = -45; x < 45; x += 7.7) {
    const Picture picture = PlateWithFailure(speck(x, x / 2, 0.001, 1e-3)).picture(true);
    const int px = static_cast<int>(std::floor(x + 60));
    const int py = static_cast<int>(std::floor(60 - x / 2));
    EXPECT_TRUE(is_reddish(picture.at(px, py))) << x;
    EXPECT_GE(count_reddish(picture), 3) << x;
  }
}

TEST(marked_facets, that_are_slivers_show_along_their_whole_length) {
  const PlateWithFailure scene({Vec3d{-40, -30, 0.001}, Vec3d{40, 30, 0.001}, Vec3d{0, 1e-6, 0.001}});
  const Picture picture = scene.picture(true);
  for (int x = -39; x < 39; ++x) {
    const int py = static_cast<int>(std::floor(60 - (x + 0.5) * 0.75));
    EXPECT_TRUE(is_reddish(picture.at(60 + x, py))) << x;
  }
}

TEST(marked_facets, seen_edge_on_still_show) {
  const PlateWithFailure scene({Vec3d{-20, 5, 1}, Vec3d{20, 5, 1}, Vec3d{0, 5, 20}});
  EXPECT_GE(count_reddish(scene.picture(true)), 40);
}

TEST(marked_facets, behind_something_stay_hidden) {
  for (const double size : {1e-3, 0.05, 3.0}) {
    EXPECT_EQ(count_reddish(PlateWithFailure(speck(10, 10, -1, size)).picture(true)), 0) << size;
    EXPECT_EQ(count_reddish(PlateWithFailure(speck(10, 10, -20, size)).picture(true)), 0) << size;
  }
}

TEST(marked_facets, that_are_large_are_drawn_as_they_are) {
  const PlateWithFailure scene({Vec3d{-30, -30, 0.01}, Vec3d{30, -30, 0.01}, Vec3d{-30, 30, 0.01}});
  EXPECT_EQ(scene.picture(true).pixels, scene.picture(false).pixels);
}

TEST(marked_facets, win_against_the_same_facet_in_another_colour) {
  const shapes::Triangle top{Vec3d{-50, -50, 0}, Vec3d{50, -50, 0}, Vec3d{50, 50, 0}};
  const shapes::Triangle other_triangulation{Vec3d{-40, -45, 0}, Vec3d{45, -45, 0}, Vec3d{41, 33, 0}};
  for (const auto& failing : {top, other_triangulation}) {
    for (const bool first : {false, true}) {
      const PlateWithFailure scene(failing, first);
      const double area = 0.5 * std::abs(cross(failing[1] - failing[0], failing[2] - failing[0]).z);
      EXPECT_NEAR(count_reddish(scene.picture(true)), area, 250) << first;
    }
  }
}

TEST(marked_facets, higher_marks_cover_lower_ones) {
  PlateWithFailure scene(speck(10, 10, 0.001, 1e-3));
  scene.mesh = shapes::mesh(shapes::joined(plate, {speck(10, 10, 0.001, 1e-3), speck(10, 10, 0.0011, 1e-3)}));
  scene.colours = std::vector<Rgb>(14, palette::out_of_reach);
  scene.marked = std::vector<std::uint8_t>(14);
  scene.colours[12] = palette::fail, scene.marked[12] = 2;
  scene.colours[13] = palette::undecided, scene.marked[13] = 1;
  EXPECT_GE(count_reddish(scene.picture(true)), 3);
  std::swap(scene.colours[12], scene.colours[13]);
  std::swap(scene.marked[12], scene.marked[13]);
  EXPECT_GE(count_reddish(scene.picture(true)), 3);
}

TEST(emphasis, shows_what_lies_behind_a_faint_surface) {
  const PlateWithFailure scene(speck(-10, -10, -20, 30));
  EXPECT_EQ(count_reddish(scene.picture(false)), 0);
  Drawing drawing = scene.drawing();
  drawing.emphasis = scene.emphasis;
  drawing.outlines = false;
  const Picture picture = render(drawing, from_above(120), 120, 120, one);
  EXPECT_NEAR(count_reddish(picture), 450, 60);
  const Rgb faint = picture.at(30, 30);
  const Rgb plain = scene.picture(false).at(30, 30);
  EXPECT_GT(faint.r, plain.r);
  EXPECT_NE(faint, drawing.background);
}

TEST(outlines, darken_the_silhouette_and_the_folds_but_not_the_faces) {
  const TriangleMesh mesh = shapes::mesh(shapes::rotated(
      shapes::gridded_box({-30, -30, -30}, {30, 30, 30}, 10), normalized(Vec3d{1, 1, 0}), 0.7));
  Drawing drawing;
  drawing.mesh = &mesh;
  drawing.occlusion = drawing.outlines = false;
  const Picture without = render(drawing, from_above(120), 120, 120, one);
  drawing.outlines = true;
  const Picture with = render(drawing, from_above(120), 120, 120, one);
  int darker = 0;
  int same = 0;
  for (std::size_t i = 0; i < with.pixels.size(); ++i) {
    EXPECT_LE(with.pixels[i].g, without.pixels[i].g);
    if (without.pixels[i] == drawing.background) continue;
    (with.pixels[i].g + 30 < without.pixels[i].g ? darker : same) += 1;
  }
  // About 290 mm of silhouette and 3 folds of 50 mm, a pixel to a millimetre and lines about a pixel wide.
  EXPECT_GT(darker, 250);
  EXPECT_LT(darker, 900);
  EXPECT_GT(same, 4 * darker);
}

TEST(occlusion, darkens_the_foot_of_a_step_and_leaves_a_plain_alone) {
  const TriangleMesh mesh = shapes::mesh(shapes::joined(plate, shapes::box({-50, -50, 0}, {0, 50, 8})));
  Drawing drawing;
  drawing.mesh = &mesh;
  drawing.outlines = false;
  const Picture picture = render(drawing, from_above(120), 120, 120, one);
  EXPECT_LT(picture.at(62, 60).g + 10, picture.at(85, 60).g);
  drawing.occlusion = false;
  EXPECT_EQ(render(drawing, from_above(120), 120, 120, one).at(85, 60), picture.at(85, 60));
}

struct LineScene {
  TriangleMesh mesh = shapes::mesh(plate);
  Picture picture(const SceneLine& line) const {
    Drawing drawing = blue_on_red(mesh);
    const std::vector<SceneLine> lines{line};
    drawing.lines = lines;
    return render(drawing, from_above(240), 240, 240, one);
  }
  // Pixels' worth of green on the blue plate or the red paper.
  double green(const SceneLine& line) const {
    double sum = 0;
    for (const Rgb pixel : picture(line).pixels) sum += pixel.g * pixel.g / 65025.0;
    return sum;
  }
};

TEST(lines, cover_their_length_times_their_width_and_two_half_disks) {
  const LineScene scene;
  for (const double width : {1.0, 3.0, 10.0}) {
    for (const Vec3d& to : {Vec3d{30, -20, 5}, Vec3d{-20, 31, 1}, Vec3d{-20, -20, 40}, Vec3d{110, -90, 3}}) {
      const Vec3d from{-20, -20, 5};
      const double length = std::hypot(to.x - from.x, to.y - from.y);
      const double expected = length * width + width * width * 0.785398;
      EXPECT_NEAR(scene.green({from, to, {0, 255, 0}, width, false}), expected, 0.02 * expected + 0.3);
    }
  }
}

TEST(lines, are_hidden_behind_facets_unless_they_are_on_top) {
  const LineScene scene;
  const SceneLine behind{{-40, 3, -30}, {40, 3, -30}, {0, 255, 0}, 2, false};
  EXPECT_EQ(scene.green(behind), 0);
  SceneLine on_top = behind;
  on_top.on_top = true;
  EXPECT_NEAR(scene.green(on_top), 163, 4);
  // Half of it stands out beside the plate.
  EXPECT_NEAR(scene.green({{0, 3, -30}, {100, 3, -30}, {0, 255, 0}, 2, false}), 101, 4);
}

TEST(lines, on_a_surface_show) {
  const LineScene scene;
  EXPECT_NEAR(scene.green({{-40, -30, 0}, {40, 37, 0}, {0, 255, 0}, 2, false}), 104.35 * 2 + 3.1, 4);
}

}  // namespace
}  // namespace gabarit
