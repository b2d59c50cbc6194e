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
  std::span<const Rgb> colours;  // one a facet of the model
  std::span<const SceneLine> lines = {};
  std::span<const std::uint8_t> emphasis = {};  // see Drawing
};

constexpr double caption_height = 5;  // mm below the picture

// The fixed views for pictures of a size, with a strip on the right that the triad has for itself.
std::vector<View> views_for(const Area& area, const Box3d& box, const Frame& frame);

// An empty frame when the model has no box. The caption and the scale bar stand below it.
void draw_view(Book& book, const ModelView& view, const std::string& caption);

// Where a point of the model lies on the page.
Place on_page(const ModelView& view, const Vec3d& point);
// A ring with a cross hair around a place of the model.
void mark_place(Book& book, const ModelView& view, const Vec3d& point, double radius);

}  // namespace gabarit::pdf
