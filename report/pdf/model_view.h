// A picture of the model on a page, to scale: with axis triad, and a scale bar below.
#pragma once

#include <cstdint>
#include <span>

#include "report/pdf/book.h"
#include "report/render.h"

namespace gabarit::pdf {

struct ModelView {
  Area area;  // mm on the page
  Camera camera;
  std::span<const Rgb> colours;               // one a facet of the model
  std::span<const std::uint8_t> marked = {};  // see Drawing
  std::span<const SceneLine> lines = {};
  std::span<const std::uint8_t> emphasis = {};  // see Drawing
  double share = 1;                             // of the report's resolution
  HPDF_Image image = nullptr;                   // drawn before with the same camera; null: drawn now
};

// A fixed view whose picture is in the document.
struct DrawnView {
  NamedView view;
  HPDF_Image image = nullptr;
};

constexpr double caption_height = 5;       // mm below the picture
constexpr double view_aspect = 82 / 48.5;  // of fixed views, wherever they are shown

// The fixed views for pictures of a size, with a strip on the right that the triad has for itself.
std::vector<NamedView> views_for(const Area& area, const Box3d& box, const Frame& frame);
// Framed by what is there, not by its box: views across the axes come closer.
std::vector<NamedView> views_for(const Area& area, const TriangleMesh& mesh, const Frame& frame);

// Around what was drawn to the scale of a camera: frame, and below it the caption and the scale bar.
void draw_frame(Canvas& canvas, const Area& area, const Camera& camera, const std::string& caption);
// An empty frame (and null) when the model has no box. The caption and the scale bar stand below it.
HPDF_Image draw_view(Book& book, const ModelView& view, const std::string& caption);

// Where a point of the model lies on the page.
Place on_page(const ModelView& view, const Vec3d& point);
// A ring with a cross hair around a place of the model.
void mark_place(Book& book, const ModelView& view, const Vec3d& point, double radius);

}  // namespace gabarit::pdf
