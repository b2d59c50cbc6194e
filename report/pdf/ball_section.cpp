#include "report/pdf/ball_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "report/finding_text.h"
#include "report/number_text.h"
#include "report/pdf/model_view.h"
#include "report/pdf/words.h"
#include "report/section.h"

namespace gabarit::pdf {

namespace {

constexpr Rgb material{225, 230, 235}, hatching{150, 160, 172};
constexpr double strip = 0.25, hatch_distance = 1.6;  // mm on the page

class SectionPlot {
 public:
  SectionPlot(Canvas& canvas, const TriangleMesh& mesh, const Area& area, const Camera& camera)
      : canvas_(canvas), view_{area, camera, {}}, section_(cut(mesh, camera)) {}

  double mm() const { return view_.area.width / view_.camera.width; }  // on the page, of one of the model
  Place place(const Vec3d& point) const { return on_page(view_, point); }

  // Whether the mesh is closed all over the plot; else nothing is filled.
  bool draw_material() const {
    const double height = view_.camera.height, reach = std::hypot(view_.camera.width, height) / 2;
    const bool filled = scan(height / 2, strip / mm(), 0, [&](Place a, Place b) {
      canvas_.fill({a.x, a.y - strip / 2, b.x - a.x, strip * 1.2}, material);
    });
    return filled && scan(reach, hatch_distance / mm(), std::numbers::pi / 4,
                          [&](Place a, Place b) { canvas_.line(a, b, hatching, 0.12); });
  }

  void draw_outline() const {
    for (const SectionEdge& edge : section_) {
      const std::array ends{page(edge.from), page(edge.to)};
      if (is_near(ends)) canvas_.polyline(ends, ink, 0.35);
    }
  }

 private:
  Place page(PagePoint p) const {
    const Area& a = view_.area;
    return {a.x + a.width / 2 + p.x * mm(), a.y + a.height / 2 - p.y * mm()};
  }

  bool is_near(const std::array<Place, 2>& ends) const {
    const Area& a = view_.area;
    const auto [left, right] = std::minmax(ends[0].x, ends[1].x);
    const auto [top, bottom] = std::minmax(ends[0].y, ends[1].y);
    return right >= a.x && left <= a.x + a.width && bottom >= a.y && top <= a.y + a.height;
  }

  // Draws what parallel lines, `distance` apart and up to `reach` from the middle, have in the material. None
  // of them when one does not leave it.
  template <class Draw>
  bool scan(double reach, double distance, double angle, const Draw& draw) const {
    const PagePoint along{std::cos(angle), std::sin(angle)};
    const double half = std::hypot(view_.camera.width, view_.camera.height) / 2;
    std::vector<std::array<Place, 2>> lines;
    const int count = static_cast<int>(std::ceil(2 * reach / distance));
    for (int i = 0; i < count; ++i) {
      const double off = -reach + (i + 0.5) * distance;
      const PagePoint start{-off * along.y, off * along.x};
      const std::optional<std::vector<Stretch>> stretches = material_along(section_, start, along);
      if (!stretches) return false;
      for (const Stretch& s : *stretches) {
        const double from = std::max(s.from, -half), to = std::min(s.to, half);
        if (from < to)
          lines.push_back({page({start.x + from * along.x, start.y + from * along.y}),
                           page({start.x + to * along.x, start.y + to * along.y})});
      }
    }
    for (const auto& [a, b] : lines) draw(a, b);
    return true;
  }

  Canvas& canvas_;
  ModelView view_;
  Section section_;
};

void draw_dashed_circle(Canvas& canvas, Place centre, double radius, Rgb colour, double width) {
  const int dashes = std::clamp(static_cast<int>(2 * std::numbers::pi * radius / 2.4), 8, 400);
  constexpr int steps = 6;
  for (int i = 0; i < dashes; ++i) {
    std::array<Place, steps + 1> arc{};
    for (int k = 0; k <= steps; ++k) {
      const double a = 2 * std::numbers::pi * (i + 0.55 * k / steps) / dashes;
      arc[static_cast<std::size_t>(k)] = {centre.x + radius * std::cos(a), centre.y + radius * std::sin(a)};
    }
    canvas.polyline(arc, colour, width);
  }
}

// A dot, and its name at an offset from it.
void draw_mark(Canvas& canvas, Place at, Place offset, const char* name) {
  const Place text{at.x + offset.x, at.y + offset.y};
  canvas.disk(at, 0.75, white);
  canvas.disk(at, 0.55, ink);
  canvas.fill({text.x - 0.4, text.y - 2.2, 2.8, 2.9}, white);
  canvas.text(text, name, small_strong_text);
}

// What the lines are, in the upper left corner.
void draw_key(Canvas& canvas, const Area& area, const WorstBall& ball, const Requirement& require) {
  const std::string sign = ball.ball ? "Ø " : "";
  const std::string value = sign + measured_text(ball.diameter, require);
  const std::string limit = "limit " + sign + number_text(ball.limit) + " " + unit_text(require);
  const double width = std::max(canvas.width(value, small_strong_text), canvas.width(limit, small_text)) + 9;
  canvas.fill({area.x + 0.5, area.y + 0.5, width, 9}, white);
  canvas.line({area.x + 1.5, area.y + 2.9}, {area.x + 6.5, area.y + 2.9}, accent, 0.6);
  canvas.text({area.x + 8, area.y + 3.8}, value, small_strong_text);
  for (const double x : {1.5, 3.3, 5.1})
    canvas.line({area.x + x, area.y + 6.9}, {area.x + x + 1.2, area.y + 6.9}, ink, 0.3);
  canvas.text({area.x + 8, area.y + 7.8}, limit, small_text);
}

void draw_ball(Canvas& canvas, const SectionPlot& plot, const WorstBall& ball) {
  const double radius = ball.diameter / 2 * plot.mm(), limit = ball.limit / 2 * plot.mm();
  const Place o = plot.place(ball.touch), c = plot.place(ball.contact);
  if (ball.ball) canvas.disk(plot.place(ball.centre()), radius, white);
  if (!ball.ball) canvas.line(o, c, accent, 0.6);
  if (ball.ball && std::isfinite(limit))
    draw_dashed_circle(canvas, plot.place(ball.touch + ball.direction * (ball.limit / 2)), limit, ink, 0.3);
}

}  // namespace

void draw_ball_section(Book& book, const Area& area, const RuleResult& result, const WorstBall& ball) {
  Canvas& canvas = book.flow.canvas();
  const Camera camera = section_camera(ball, book.model().box, area.width / area.height);
  const SectionPlot plot(canvas, book.model().mesh, area, camera);
  bool filled = false;
  canvas.clipped(area, [&] {
    filled = plot.draw_material();
    draw_ball(canvas, plot, ball);
    plot.draw_outline();
    const Place o = plot.place(ball.touch), c = plot.place(ball.contact);
    if (ball.ball) canvas.circle(plot.place(ball.centre()), ball.diameter / 2 * plot.mm(), accent, 0.6);
    draw_mark(canvas, o, {-3.6, -1.3}, "O");
    draw_mark(canvas, c, {1.5, 3.4}, "C");
    draw_key(canvas, area, ball, result.rule.require);
  });
  draw_frame(canvas, area, camera, filled ? "Section through O and C" : "Open section through O and C");
}

}  // namespace gabarit::pdf
