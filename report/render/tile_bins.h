// Which facets may show in which tile of the picture. A tile is drawn with a rim around it, so that what is
// decided between neighbouring samples does not know where the tiles are cut.
#pragma once

#include <span>
#include <vector>

#include "report/render/screen.h"

namespace gabarit {

constexpr int tile_pixels = 64;
constexpr int rim_pixels = 3;
constexpr int tile_samples = (tile_pixels + 2 * rim_pixels) * samples_per_pixel;  // across, with the rim

// At most 16 entries a facet: what is larger, or reaches past what integers hold, is listed once for all
// tiles.
class TileBins {
 public:
  // `marked`: one a facet or empty; facets between the samples are kept only when they are marked.
  TileBins(const TriangleMesh& mesh, const std::vector<ScreenPoint>& points,
           std::span<const std::uint8_t> marked, const Screen& screen, const Device& device);

  int columns() const { return columns_; }
  int tiles() const { return columns_ * rows_; }
  // Both ascending.
  std::span<const FacetId> of(int tile) const;
  std::span<const FacetId> large() const { return large_; }

 private:
  int columns_, rows_;
  std::vector<std::size_t> first_;  // of each tile, and the end
  std::vector<FacetId> facets_, large_;
};

}  // namespace gabarit
