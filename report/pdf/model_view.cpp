#include "report/pdf/model_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "report/scale_bar.h"
#include "report/triad.h"

namespace gabarit::pdf {

static constexpr TextStyle mark_text{Face::regular, 6.5, ink, 3};

static constexpr double triad_strip = 12;  // mm

// Makes room for the triad on the right of pictures that `views` were made for without it.
static std::vector<NamedView> beside_triad(std::vector<NamedView> views, const Area& area) {
  const double inner = area.width - triad_strip;
  for (NamedView& view : views) {
    Camera& camera = view.camera;
    const double mm = camera.width / inner;  // of the model, a millimetre of the page
    camera.width = mm * area.width;
    camera.target += camera.right * (mm * triad_strip / 2);
  }
  return views;
}

static double inner_aspect(const Area& area) { return (area.width - triad_strip) / area.height; }

std::vector<NamedView> views_for(const Area& area, const Box3d& box, const Frame& frame) {
  return beside_triad(fixed_views(box, frame, inner_aspect(area)), area);
}

std::vector<NamedView> views_for(const Area& area, const TriangleMesh& mesh, const Frame& frame) {
  return beside_triad(fixed_views(mesh, frame, inner_aspect(area)), area);
}

// Its label left of it, both at the right of the caption's line.
static void draw_scale_bar(Canvas& canvas, const Area& area, const ScaleBar& bar) {
  const double length = bar.share * area.width;
  const double x = area.x + area.width - length, y = area.y + area.height + 2.3;
  for (int i = 0; i < bar.divisions; ++i) {
    const Area part{x + length * i / bar.divisions, y, length / bar.divisions, 1};
    canvas.fill(part, i % 2 == 0 ? ink : white);
  }
  canvas.frame({x, y, length, 1}, ink, 0.15);
  canvas.text_right({x - 1.5, y + 1.3}, bar.label, label_text);
}

static Rgb axis_colour(char name) {
  return name == 'x' ? Rgb{170, 30, 40} : name == 'y' ? Rgb{30, 120, 60} : Rgb{30, 70, 160};
}

static void draw_axis(Canvas& canvas, Place origin, double size, const TriadAxis& axis) {
  const Rgb colour = axis_colour(axis.name);
  const double shown = std::hypot(axis.tip.x, axis.tip.y);
  const Place tip{origin.x + size * axis.tip.x, origin.y - size * axis.tip.y};
  const std::string label(1, axis.name);
  if (shown < 0.2) {  // it points at the reader (a dot) or away (a cross)
    canvas.circle(origin, 0.9, colour, 0.25);
    if (axis.toward > 0) canvas.disk(origin, 0.35, colour);
    return canvas.text({origin.x - 2.6, origin.y + 2.6}, label, mark_text);
  }
  const double dx = axis.tip.x / shown, dy = -axis.tip.y / shown;
  canvas.line(origin, tip, colour, 0.35);
  const std::array head{Place{tip.x + 1.2 * dx, tip.y + 1.2 * dy},
                        Place{tip.x - 0.55 * dy, tip.y + 0.55 * dx},
                        Place{tip.x + 0.55 * dy, tip.y - 0.55 * dx}};
  canvas.polygon(head, colour);
  canvas.text_centred({tip.x + 2.6 * dx, tip.y + 2.6 * dy + 0.8}, label, mark_text);
}

static void draw_triad(Canvas& canvas, const ModelView& view) {
  const Place origin{view.area.x + view.area.width - 8, view.area.y + view.area.height - 8};
  for (const TriadAxis& axis : triad(view.camera)) draw_axis(canvas, origin, 4.5, axis);
}

static HPDF_Image rendered(Book& book, const ModelView& view) {
  const double dots_per_mm = view.share * book.resolution / 25.4;
  const auto pixels = [&](double mm) { return std::max(8, static_cast<int>(std::lround(mm * dots_per_mm))); };
  Drawing drawing;
  drawing.mesh = &book.model().mesh;
  drawing.facet_colours = view.colours;
  drawing.marked = view.marked;
  drawing.lines = view.lines;
  drawing.emphasis = view.emphasis;
  return book.flow.document().add_picture(
      render(drawing, view.camera, pixels(view.area.width), pixels(view.area.height), book.options->device));
}

void draw_frame(Canvas& canvas, const Area& area, const Camera& camera, const std::string& caption) {
  const ScaleBar bar = scale_bar(camera);
  draw_scale_bar(canvas, area, bar);
  canvas.frame(area, hairline);
  const double width = (1 - bar.share) * area.width - canvas.width(bar.label, label_text) - 5;
  canvas.text({area.x, area.y + area.height + 3.6}, fitted(canvas.fonts(), caption, label_text, width),
              label_text);
}

HPDF_Image draw_view(Book& book, const ModelView& view, const std::string& caption) {
  Canvas& canvas = book.flow.canvas();
  if (book.model().box.empty()) {
    canvas.frame(view.area, hairline);
    canvas.text({view.area.x, view.area.y + view.area.height + 3.6},
                fitted(canvas.fonts(), caption, label_text, view.area.width), label_text);
    return nullptr;
  }
  const HPDF_Image image = view.image != nullptr ? view.image : rendered(book, view);
  canvas.picture(view.area, image);
  draw_triad(canvas, view);
  draw_frame(canvas, view.area, view.camera, caption);
  return image;
}

Place on_page(const ModelView& view, const Vec3d& point) {
  const PagePoint p = project(view.camera, point);
  const double scale = view.area.width / view.camera.width;
  return {view.area.x + view.area.width / 2 + p.x * scale, view.area.y + view.area.height / 2 - p.y * scale};
}

void mark_place(Book& book, const ModelView& view, const Vec3d& point, double radius) {
  const Place at = on_page(view, point);
  const Area& a = view.area;
  const bool inside = at.x >= a.x && at.x <= a.x + a.width && at.y >= a.y && at.y <= a.y + a.height;
  if (!inside) return;
  Canvas& canvas = book.flow.canvas();
  canvas.clipped(view.area, [&] {
    // White below ink: it shows on any colour.
    for (const auto& [colour, width] : {std::pair{white, 0.9}, std::pair{ink, 0.35}}) {
      canvas.circle(at, radius, colour, width);
      for (const auto& [dx, dy] : {std::pair{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}) {
        canvas.line({at.x + radius * dx, at.y + radius * dy},
                    {at.x + (radius + 2.5) * dx, at.y + (radius + 2.5) * dy}, colour, width);
      }
    }
  });
}

}  // namespace gabarit::pdf
