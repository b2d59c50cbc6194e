#include "report/render.h"

#include <stdexcept>

#include "gpu/parallel_for.h"
#include "report/render/lines.h"
#include "report/render/marks.h"
#include "report/render/occlusion.h"
#include "report/render/outlines.h"
#include "report/render/shade.h"

namespace gabarit {
namespace {

struct Job {
  Facets facets;
  const TileBins* bins;
  std::vector<PlacedLine> lines;
};

// Draws the facets that `wanted` picks.
template <class Wanted>
void draw_facets(const Job& job, int tile, const Tile& at, DepthBuffer& buffer, Wanted wanted) {
  for (const auto& list : {job.bins->of(tile), job.bins->large()}) {
    for (const FacetId f : list) {
      if (wanted(f)) draw_facet(job.facets, f, at.left, at.top, buffer);
    }
  }
}

// Faint facets never hide emphasised ones, but cover them with their skin.
void draw_with_emphasis(const Job& job, int number, Tile& tile) {
  const std::span<const std::uint8_t> emphasis = job.facets.drawing->emphasis;
  DepthBuffer faint;
  draw_facets(job, number, tile, faint, [&](FacetId f) { return emphasis[f] == 0; });
  draw_facets(job, number, tile, tile.front, [&](FacetId f) { return emphasis[f] != 0; });
  tile.skin.assign(samples_in_tile, no_facet);
  for (std::size_t i = 0; i < samples_in_tile; ++i) {
    if (tile.front.facet[i] == no_facet) {
      tile.front.facet[i] = faint.facet[i];
      tile.front.depth[i] = faint.depth[i];
    } else if (faint.depth[i] > tile.front.depth[i] + samples_per_pixel) {
      tile.skin[i] = faint.facet[i];
    }
  }
}

void draw_tile(const Job& job, int number, Film& film) {
  if (job.bins->of(number).empty() && job.bins->large().empty() && job.lines.empty()) return;
  Tile tile;
  const Drawing& drawing = *job.facets.drawing;
  tile.left = (number % job.bins->columns() * tile_pixels - rim_pixels) * samples_per_pixel;
  tile.top = (number / job.bins->columns() * tile_pixels - rim_pixels) * samples_per_pixel;
  if (drawing.emphasis.empty()) {
    draw_facets(job, number, tile, tile.front, [](FacetId) { return true; });
  } else {
    draw_with_emphasis(job, number, tile);
  }
  shade(job.facets, tile);
  if (drawing.outlines) ink_outlines(tile);
  stamp_marks(job.facets, job.bins->of(number), job.bins->large(), tile);
  draw_lines(job.lines, tile);
  resolve(tile, film);
}

}  // namespace

Picture render(const Drawing& drawing, const Camera& camera, int width, int height, const Device& device) {
  constexpr int most = 8192;
  if (width < 1 || height < 1 || width > most || height > most) {
    throw std::length_error("a picture has 1 to 8192 pixels a side");
  }
  static const TriangleMesh nothing;
  Drawing drawn = drawing;
  const Screen screen(camera, width, height);
  if (drawn.mesh == nullptr || !screen.valid()) {
    drawn = Drawing();
    drawn.mesh = &nothing;
    drawn.background = drawing.background;
  }
  const std::vector<ScreenPoint> points = on_screen(*drawn.mesh, screen, device);
  const TileBins bins(*drawn.mesh, points, drawn.marked, screen, device);
  const Job job{{&drawn, &screen, &points}, &bins, placed(drawn.lines, screen)};
  Film film(width, height, light_of(drawn.background));
  parallel_for_cpu(
      device, bins.tiles(), [&](std::int64_t tile) { draw_tile(job, static_cast<int>(tile), film); }, 1);
  return developed(film, drawn.occlusion, device);
}

}  // namespace gabarit
