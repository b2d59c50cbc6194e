#include "report/pdf/sketch.h"

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include <fmt/format.h>

namespace gabarit::pdf {

namespace {

constexpr Rgb part_fill{225, 230, 235};

struct Sketch {
  Canvas& canvas;
  Area area;

  // Fractions of the area, y upwards.
  Place at(double x, double y) const { return {area.x + area.width * x, area.y + area.height * (1 - y)}; }
  double mm(double share) const { return area.height * share; }

  void part(std::vector<Place> places) const {
    canvas.polygon(places, part_fill);
    places.push_back(places.front());
    canvas.polyline(places, ink, 0.3);
  }
  void label(Place place, std::string_view text) const { canvas.text_centred(place, text, label_text); }
  void arrow(Place from, Place to) const {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0)) return;
    const double dx = (to.x - from.x) / length, dy = (to.y - from.y) / length;
    canvas.line(from, to, accent, 0.3);
    canvas.polygon(std::array{to, Place{to.x - 1.6 * dx - 0.6 * dy, to.y - 1.6 * dy + 0.6 * dx},
                              Place{to.x - 1.6 * dx + 0.6 * dy, to.y - 1.6 * dy - 0.6 * dx}},
                   accent);
  }
};

// Points of an arc on the page, angles counter-clockwise from the right.
void add_arc(std::vector<Place>& places, Place centre, double radius, double from, double to) {
  constexpr int steps = 24;
  for (int i = 0; i <= steps; ++i) {
    const double a = from + (to - from) * i / steps;
    places.push_back({centre.x + radius * std::cos(a), centre.y - radius * std::sin(a)});
  }
}

constexpr double pi = 3.14159265358979323846;

// In plan: the disk rolls around the outline and bridges a pocket that is narrower than itself.
void draw_column(const Sketch& s, const Arguments& arguments) {
  const double r = s.mm(0.17);
  const Place a = s.at(0.34, 0.52), b = s.at(0.68, 0.52);
  const double big = s.mm(0.2);
  std::vector<Place> outline;
  add_arc(outline, a, big, 0.25 * pi, 1.75 * pi);
  add_arc(outline, b, big, 1.25 * pi, 2.75 * pi);
  s.part(outline);
  std::vector<Place> path;
  add_arc(path, a, big + r, 0.28 * pi, 1.72 * pi);
  s.canvas.polyline(path, accent, 0.2);
  path.clear();
  add_arc(path, b, big + r, 1.28 * pi, 2.72 * pi);
  s.canvas.polyline(path, accent, 0.2);
  const Place centre{a.x + (big + r) * std::cos(0.72 * pi), a.y - (big + r) * std::sin(0.72 * pi)};
  s.canvas.circle(centre, r, accent, 0.4);
  s.canvas.disk(centre, 0.5, accent);
  const std::string size =
      arguments.has("diameter") ? fmt::format("Ø {:g} mm", arguments.number("diameter")) : "Ø";
  s.label(s.at(0.5, 0.01), size + ", from above");
}

void draw_sphere(const Sketch& s, const Arguments& arguments) {
  const double r = s.mm(0.24);
  std::vector<Place> outline{s.at(0.05, 0.1)};
  outline.push_back(s.at(0.05, 0.45)), outline.push_back(s.at(0.35, 0.45)),
      outline.push_back(s.at(0.42, 0.25));
  outline.push_back(s.at(0.55, 0.25)), outline.push_back(s.at(0.62, 0.45)),
      outline.push_back(s.at(0.95, 0.45));
  outline.push_back(s.at(0.95, 0.1));
  s.part(outline);
  const Place centre{s.at(0.5, 0).x, s.at(0, 0.45).y - 0.83 * r};
  s.canvas.circle(centre, r, accent, 0.4);
  const std::string size =
      arguments.has("diameter") ? fmt::format("Ø {:g} mm", arguments.number("diameter")) : "Ø";
  s.canvas.text({centre.x + r + 1.5, centre.y - 0.5 * r}, size, label_text);
}

void draw_height(const Sketch& s, const Arguments& arguments) {
  s.canvas.line(s.at(0.02, 0.14), s.at(0.98, 0.14), ink, 0.4);
  s.part({s.at(0.5, 0.14), s.at(0.5, 0.86), s.at(0.72, 0.96), s.at(0.9, 0.7), s.at(0.9, 0.14)});
  const auto mark = [&](const char* name, double y) {
    if (!arguments.has(name)) return;
    s.canvas.dashed_line(s.at(0.02, y), s.at(0.98, y), accent, 0.3);
    s.canvas.text({s.at(0.02, 0).x, s.at(0, y).y - 0.9},
                  fmt::format("{} {:g} mm", name, arguments.number(name)), label_text);
  };
  mark("from", 0.34);
  mark("to", 0.72);
  s.canvas.text({s.at(0.02, 0).x, s.at(0, 0.02).y}, "ground", label_text);
}

// A corner, and the ball that its rounding holds.
void draw_radius(const Sketch& s) {
  const double r = s.mm(0.34);
  const Place centre = s.at(0.52, 0.42);
  std::vector<Place> outline{{s.at(0.1, 0).x, s.at(0, 0.05).y}, {s.at(0.1, 0).x, centre.y - r}};
  add_arc(outline, centre, r, 0.5 * pi, 0);
  outline.push_back({centre.x + r, s.at(0, 0.05).y});
  s.part(outline);
  s.canvas.circle(centre, r, accent, 0.4);
  const Place touch{centre.x + r * std::cos(pi / 4), centre.y - r * std::sin(pi / 4)};
  s.arrow(centre, touch);
  s.label({centre.x + 0.25 * r, centre.y - 0.5 * r}, "R");
}

// Two sides of a wall and the largest ball between them.
void draw_thickness(const Sketch& s) {
  std::vector<Place> outline;
  const Place centre = s.at(0.5, -1.3);
  add_arc(outline, centre, s.mm(2.1), 0.6 * pi, 0.4 * pi);
  std::vector<Place> inner;
  add_arc(inner, centre, s.mm(1.66), 0.4 * pi, 0.6 * pi);
  outline.insert(outline.end(), inner.begin(), inner.end());
  s.part(outline);
  const Place ball{centre.x, centre.y - s.mm(1.88)};
  s.canvas.circle(ball, s.mm(0.22), accent, 0.4);
  s.arrow(ball, {ball.x, ball.y - s.mm(0.22)});
  s.arrow(ball, {ball.x, ball.y + s.mm(0.22)});
  s.canvas.text({ball.x + 1.2, ball.y + 1}, "2t", label_text);
}

// A gap between two parts and the largest ball in it.
void draw_clearance(const Sketch& s) {
  s.part({s.at(0.05, 0.1), s.at(0.05, 0.9), s.at(0.34, 0.9), s.at(0.34, 0.1)});
  s.part({s.at(0.66, 0.1), s.at(0.66, 0.9), s.at(0.95, 0.9), s.at(0.95, 0.1)});
  const Place ball = s.at(0.5, 0.5);
  const double r = 0.16 * s.area.width;
  s.canvas.circle(ball, r, accent, 0.4);
  s.arrow(ball, {ball.x - r, ball.y});
  s.arrow(ball, {ball.x + r, ball.y});
}

using SelectorSketch = void (*)(const Sketch&, const Arguments&);
using MeasureSketch = void (*)(const Sketch&);

const std::map<std::string, SelectorSketch>& selector_sketches() {
  static const std::map<std::string, SelectorSketch> sketches{{"contact: vertical cylinder", draw_column},
                                                              {"contact: sphere", draw_sphere},
                                                              {"height: ", draw_height}};
  return sketches;
}

const std::map<std::string, MeasureSketch>& measure_sketches() {
  static const std::map<std::string, MeasureSketch> sketches{
      {"radius", draw_radius}, {"thickness", draw_thickness}, {"clearance", draw_clearance}};
  return sketches;
}

std::string key(const Selector& selector) { return selector.name + ": " + selector.variant; }

}  // namespace

bool has_sketch(const Selector& selector) { return selector_sketches().contains(key(selector)); }
bool has_sketch(const Measure& measure) { return measure_sketches().contains(measure.name); }

void draw_sketch(Canvas& canvas, const Area& area, const Selector& selector, const Arguments& arguments) {
  canvas.fill(area, shade);
  selector_sketches().at(key(selector))({canvas, {area.x + 2, area.y + 2, area.width - 4, area.height - 4}},
                                        arguments);
}

void draw_sketch(Canvas& canvas, const Area& area, const Measure& measure) {
  canvas.fill(area, shade);
  measure_sketches().at(measure.name)({canvas, {area.x + 2, area.y + 2, area.width - 4, area.height - 4}});
}

}  // namespace gabarit::pdf
