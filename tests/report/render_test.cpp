#include "report/render.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include <gmock/gmock.h>

#include "report/palette.h"
#include "tests/report/picture_checks.h"

namespace gabarit {
namespace {

const Device one = Device::cpu(1);

// Of a convex solid in a direction: half of what its facets project to.
double shadow_area(const TriangleMesh& mesh, const Vec3d& toward) {
  double area = 0;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    area += 0.5 * facet_area(mesh, f) * std::abs(dot(facet_normal(mesh, f), toward));
  }
  return area;
}

TEST(render, a_turned_box_covers_as_much_paper_as_its_shadow) {
  for (const double angle : {0.0, 0.3, 0.8, 2.0}) {
    const TriangleMesh mesh = shapes::mesh(
        shapes::rotated(shapes::box({-10, -20, -15}, {10, 20, 15}), normalized(Vec3d{1, 2, 3}), angle));
    const Camera camera = from_above(80);
    const double pixel = camera.width / 200;
    const double covered = covered_pixels(render(blue_on_red(mesh), camera, 200, 200, one)) * pixel * pixel;
    const double expected = shadow_area(mesh, camera.toward());
    // The outline is at most 140 mm long and off by less than a tenth of a sample on average.
    EXPECT_NEAR(covered, expected, 140 * 0.1 * pixel / 4) << angle;
  }
}

TEST(render, edges_are_smooth) {
  const TriangleMesh mesh = shapes::mesh({{Vec3d{-40, -40, 0}, Vec3d{40, -40, 0}, Vec3d{40, -33, 0}}});
  const Picture picture = render(blue_on_red(mesh), from_above(80), 80, 80, one);
  std::vector<int> values;
  for (int x = 5; x < 75; ++x) {
    for (int y = 0; y < 80; ++y) values.push_back(picture.at(x, y).r);
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  EXPECT_GE(values.size(), 20U);
}

TEST(render, lengths_are_to_scale) {
  const TriangleMesh mesh = shapes::mesh(shapes::box({-25, -10, 0}, {25, 10, 5}));
  const Picture picture = render(blue_on_red(mesh), from_above(100, 2), 200, 100, one);
  int columns = 0;
  for (int x = 0; x < 200; ++x) columns += paper_share(picture.at(x, 50)) < 0.5 ? 1 : 0;
  int rows = 0;
  for (int y = 0; y < 100; ++y) rows += paper_share(picture.at(100, y)) < 0.5 ? 1 : 0;
  EXPECT_EQ(columns, 100);
  EXPECT_EQ(rows, 40);
}

struct Soup {
  shapes::Triangles triangles;
  std::vector<Rgb> colours;
};

Soup random_soup(std::uint32_t seed, int count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> at(-50, 50);
  Soup soup;
  for (int i = 0; i < count; ++i) {
    shapes::Triangle triangle;
    for (Vec3d& p : triangle) p = {at(random), at(random), at(random)};
    soup.triangles.push_back(triangle);
    soup.colours.push_back({255, static_cast<std::uint8_t>(i * 255 / count), 0});
  }
  return soup;
}

// The triangle that a ray down from (x, y) meets first; -1 for none.
int first_hit(const shapes::Triangles& triangles, double x, double y) {
  int nearest = -1;
  double height = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    const auto side = [&](const Vec3d& p, const Vec3d& q) {
      return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    };
    const double u = side(b, c);
    const double v = side(c, a);
    const double w = side(a, b);
    if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))) continue;
    const double z = (u * a.z + v * b.z + w * c.z) / (u + v + w);
    if (z > height) height = z, nearest = static_cast<int>(i);
  }
  return nearest;
}

TEST(render, shows_the_facet_that_a_ray_meets_first) {
  constexpr int size = 90;
  constexpr int count = 20;
  int compared = 0;
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    const Soup soup = random_soup(seed, count);
    const TriangleMesh mesh = shapes::mesh(soup.triangles);
    Drawing drawing = blue_on_red(mesh);
    drawing.background = {0, 0, 255};
    drawing.facet_colours = soup.colours;
    const Picture picture = render(drawing, from_above(90), size, size, one);
    for (int py = 0; py < size; ++py) {
      for (int px = 0; px < size; ++px) {
        // Only pixels that lie in one facet with all that the filter reaches.
        const auto hit = [&](double dx, double dy) {
          return first_hit(soup.triangles, px + dx - 45, 45 - (py + dy));
        };
        const int expected = hit(0.5, 0.5);
        bool clear = true;
        for (int k = 0; k < 36 && clear; ++k) clear = hit((k % 6 - 0.5) / 4, (k / 6 - 0.5) / 4) == expected;
        if (!clear) continue;
        ++compared;
        const Rgb pixel = picture.at(px, py);
        if (expected < 0) {
          EXPECT_EQ(pixel, drawing.background);
        } else {
          // The darkest facets have r = 85, where neighbouring colours are 4 apart.
          const double ratio = soup.colours[static_cast<std::size_t>(expected)].g / 255.0;
          EXPECT_NEAR(pixel.g, ratio * pixel.r, 1.5);
        }
      }
    }
  }
  EXPECT_GT(compared, 6 * size * size / 3);
}

// A ring with every kind of colour and mark, and a wall through it.
struct Scene {
  shapes::Triangles triangles =
      shapes::joined(shapes::rotated(shapes::torus(30, 9, 60, 20), normalized(Vec3d{1, 1, 0}), 0.6),
                     shapes::gridded_box({-40, -3, -20}, {40, 3, 5}, 7));
  std::vector<Rgb> colours;
  std::vector<std::uint8_t> marked, emphasis;

  Scene() {
    std::mt19937 random(7);
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      const auto kind = random() % 10;
      colours.push_back(kind == 0 ? palette::fail : kind == 1 ? palette::undecided : palette::out_of_reach);
      marked.push_back(kind == 0 ? 2 : kind == 1 ? 1 : 0);
      emphasis.push_back(kind < 4 ? 1 : 0);
    }
  }
};

template <class T>
std::vector<T> reordered(const std::vector<T>& values, const std::vector<std::uint32_t>& order) {
  std::vector<T> result;
  for (const std::uint32_t i : order) result.push_back(values[i]);
  return result;
}

Picture picture_of(const Scene& scene, bool emphasised, const Device& device) {
  const TriangleMesh mesh = shapes::mesh(scene.triangles);
  const std::vector<SceneLine> lines{{{-45, -30, 0}, {45, 30, 5}, palette::trace, 3, false},
                                     {{-45, 30, 0}, {45, -30, 5}, {0, 0, 0}, 2, true}};
  Drawing drawing;
  drawing.mesh = &mesh;
  drawing.facet_colours = scene.colours;
  drawing.marked = scene.marked;
  drawing.lines = lines;
  if (emphasised) drawing.emphasis = scene.emphasis;
  return render(drawing, fixed_views(bounding_box(mesh), {}, 1.5).back().camera, 300, 200, device);
}

TEST(render, gives_the_same_bytes_on_any_number_of_threads) {
  const Scene scene;
  for (const bool emphasised : {false, true}) {
    const Picture picture = picture_of(scene, emphasised, one);
    EXPECT_EQ(picture.pixels, picture_of(scene, emphasised, Device::cpu(2)).pixels);
    EXPECT_EQ(picture.pixels, picture_of(scene, emphasised, Device::cpu(7)).pixels);
    EXPECT_EQ(picture.pixels,
              picture_of(scene, emphasised, {Device::Kind::cpu, 2, 0, VectorSet::portable}).pixels);
  }
}

TEST(render, gives_the_same_bytes_for_facets_in_any_order) {
  const Scene scene;
  for (const bool emphasised : {false, true}) {
    const Picture picture = picture_of(scene, emphasised, one);
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
      Scene other;
      std::vector<std::uint32_t> order;
      other.triangles = shapes::permuted(scene.triangles, seed, &order);
      other.colours = reordered(scene.colours, order);
      other.marked = reordered(scene.marked, order);
      other.emphasis = reordered(scene.emphasis, order);
      EXPECT_EQ(picture.pixels, picture_of(other, emphasised, one).pixels);
    }
  }
}

TEST(render, shows_both_sides_of_a_facet_alike) {
  const shapes::Triangles solid =
      shapes::rotated(shapes::box({-10, -20, -15}, {10, 20, 15}), normalized(Vec3d{1, 2, 3}), 0.8);
  const auto picture = [](const TriangleMesh& mesh) {
    Drawing drawing;
    drawing.mesh = &mesh;
    return render(drawing, from_above(80), 100, 100, one);
  };
  EXPECT_EQ(picture(shapes::mesh(solid)).pixels, picture(shapes::mesh(shapes::flipped(solid))).pixels);
}

TEST(render, a_model_and_a_camera_moved_together_give_the_same_picture) {
  const Scene scene;
  const auto at = [&](const Vec3d& offset) {
    const TriangleMesh mesh = shapes::mesh(shapes::moved(scene.triangles, offset));
    Drawing drawing;
    drawing.mesh = &mesh;
    drawing.facet_colours = scene.colours;
    Camera camera = fixed_views({{-40, -40, -40}, {40, 40, 40}}, {}, 1.5).back().camera;
    camera.target += offset;
    return render(drawing, camera, 300, 200, one);
  };
  const Picture here = at({});
  const Picture there = at({1024, -512, 256});
  int different = 0;
  for (std::size_t i = 0; i < here.pixels.size(); ++i) {
    different += std::abs(here.pixels[i].g - there.pixels[i].g) > 8 ? 1 : 0;
  }
  EXPECT_LT(different, 60);  // of 60000: rounding moves a corner by a 256th of a sample
}

TEST(render, what_is_not_finite_is_left_out_and_the_rest_is_drawn) {
  TriangleMesh mesh = shapes::mesh(shapes::box({-10, -10, 0}, {10, 10, 5}));
  const double expected = covered_pixels(render(blue_on_red(mesh), from_above(40), 100, 100, one));
  const auto first = static_cast<VertexId>(mesh.vertices.size());
  for (const double wrong : {std::nan(""), double{INFINITY}, -double{INFINITY}}) {
    mesh.vertices.push_back({wrong, 0, 20});
    mesh.facets.push_back({0, 1, static_cast<VertexId>(mesh.vertices.size() - 1)});
  }
  mesh.facets.push_back({first, first, first});
  EXPECT_EQ(covered_pixels(render(blue_on_red(mesh), from_above(40), 100, 100, one)), expected);
}

TEST(render, a_facet_as_large_as_a_country_covers_what_it_should) {
  const double far = 1e9;
  const TriangleMesh half = shapes::mesh({{Vec3d{0, -far, 0}, Vec3d{far, 0, 0}, Vec3d{0, far, 0}}});
  EXPECT_NEAR(covered_pixels(render(blue_on_red(half), from_above(10), 200, 100, one)), 200 * 100 / 2, 20);
  const TriangleMesh all = shapes::mesh({{Vec3d{-far, -far, -far}, Vec3d{far, -far, far}, Vec3d{0, far, 0}}});
  EXPECT_EQ(covered_pixels(render(blue_on_red(all), from_above(10), 200, 100, one)), 200 * 100);
}

TEST(render, coordinates_at_the_end_of_the_world_do_no_harm) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(-300, 308);
  shapes::Triangles triangles;
  std::vector<std::uint8_t> marked(300);
  for (auto& mark : marked) {
    shapes::Triangle triangle;
    for (Vec3d& p : triangle) {
      for (int i = 0; i < 3; ++i) p[i] = (random() % 2 == 0 ? 1 : -1) * std::pow(10.0, exponent(random));
    }
    triangles.push_back(triangle);
    mark = static_cast<std::uint8_t>(random() % 3);
  }
  const TriangleMesh mesh = shapes::mesh(triangles);
  Drawing drawing;
  drawing.mesh = &mesh;
  drawing.marked = marked;
  const std::vector<SceneLine> lines{{{-1e300, 0, 0}, {1e300, 1, 0}, {}, 1e9, true}, {{}, {}, {}, 3, true}};
  drawing.lines = lines;
  for (const double width : {1e-300, 1e-9, 1.0, 1e9, 1e300}) {
    EXPECT_EQ(render(drawing, from_above(width), 70, 70, Device::cpu(2)).pixels.size(), 4900U);
  }
}

TEST(render, nothing_to_show_is_blank_paper) {
  const TriangleMesh empty;
  const TriangleMesh box = shapes::mesh(shapes::box({-1, -1, -1}, {1, 1, 1}));
  const std::vector<Rgb> blank(50 * 40, Rgb{255, 255, 255});
  EXPECT_EQ(render({}, from_above(1), 50, 40, one).pixels, blank);
  Drawing drawing;
  drawing.mesh = &empty;
  EXPECT_EQ(render(drawing, from_above(1), 50, 40, one).pixels, blank);
  drawing.mesh = &box;
  for (const double width : {0.0, -1.0, std::nan(""), double{INFINITY}}) {
    EXPECT_EQ(render(drawing, from_above(width), 50, 40, one).pixels, blank);
  }
}

TEST(render, refuses_pictures_of_no_size_or_too_large) {
  for (const auto& [width, height] : {std::pair{0, 10}, {10, 0}, {-1, 10}, {8193, 1}}) {
    EXPECT_THROW(render({}, from_above(1), width, height, one), std::length_error);
  }
  EXPECT_EQ(render({}, from_above(1), 1, 1, one).pixels.size(), 1U);
}

}  // namespace
}  // namespace gabarit
