#include "report/render/tile_bins.h"

#include <algorithm>

#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

// Tiles that a facet may show in, ends included.
struct Footprint {
  std::int16_t left = 0, right = -1, top = 0, bottom = -1;
  bool far = false;

  bool empty() const { return left > right || top > bottom; }
  std::int64_t count() const { return std::int64_t{right - left + 1} * (bottom - top + 1); }
  bool large() const { return far || count() > 16; }
};

struct Binning {
  const TriangleMesh& mesh;
  const std::vector<ScreenPoint>& points;
  std::span<const std::uint8_t> marked;
  int columns, rows;

  Footprint footprint(FacetId f) const;
};

Footprint Binning::footprint(FacetId f) const {
  const auto& corners = mesh.facets[f];
  const ScreenPoint a = points[corners[0]];
  const ScreenPoint b = points[corners[1]];
  const ScreenPoint c = points[corners[2]];
  if (a.nowhere() || b.nowhere() || c.nowhere()) return {};
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
  constexpr int tile_units = tile_pixels * samples_per_pixel * units_per_sample;
  constexpr int rim = rim_pixels * samples_per_pixel * units_per_sample;
  if (right < -rim || left > columns * tile_units + rim || bottom < -rim || top > rows * tile_units + rim) {
    return {};
  }
  const bool is_marked = !marked.empty() && marked[f] != 0;
  const bool between_samples =
      first_sample(left) > last_sample(right) || first_sample(top) > last_sample(bottom);
  if (between_samples && !is_marked) return {};
  const auto tile = [](int number) { return static_cast<std::int16_t>(number); };  // 128 a side at most
  return {tile(std::max(0, left - rim) / tile_units), tile(std::min(columns - 1, (right + rim) / tile_units)),
          tile(std::max(0, top - rim) / tile_units), tile(std::min(rows - 1, (bottom + rim) / tile_units)),
          a.far() || b.far() || c.far()};
}

constexpr std::size_t chunk_facets = 1 << 15;

// A facet that may show, and where.
struct Shown {
  FacetId facet;
  Footprint print;
};

std::vector<Shown> shown_of(const Binning& binning, std::size_t chunk) {
  std::vector<Shown> shown;
  const std::size_t end = std::min((chunk + 1) * chunk_facets, binning.mesh.facet_count());
  for (std::size_t i = chunk * chunk_facets; i < end; ++i) {
    const auto f = static_cast<FacetId>(i);
    if (const Footprint print = binning.footprint(f); !print.empty()) shown.push_back({f, print});
  }
  return shown;
}

// Calls act(facet, tile) in the order of the facets, and `act(facet, -1)` for large ones.
template <class Act>
void for_each_entry(const std::vector<Shown>& shown, int columns, Act act) {
  for (const auto& [f, print] : shown) {
    if (print.large()) {
      act(f, -1);
      continue;
    }
    for (int row = print.top; row <= print.bottom; ++row) {
      for (int column = print.left; column <= print.right; ++column) act(f, row * columns + column);
    }
  }
}

int tiles_for(int pixels) { return (pixels + tile_pixels - 1) / tile_pixels; }

}  // namespace

TileBins::TileBins(const TriangleMesh& mesh, const std::vector<ScreenPoint>& points,
                   std::span<const std::uint8_t> marked, const Screen& screen, const Device& device)
    : columns_(tiles_for(screen.width())), rows_(tiles_for(screen.height())) {
  const Binning binning{mesh, points, marked, columns_, rows_};
  const std::size_t chunks = (mesh.facet_count() + chunk_facets - 1) / chunk_facets;
  // Bin 0 is that of the large ones. Counted a chunk at a time, then every chunk knows where to write.
  const auto bins = static_cast<std::size_t>(tiles()) + 1;
  std::vector<std::uint32_t> counts(chunks * bins);
  std::vector<std::vector<Shown>> shown(chunks);
  parallel_for_cpu(
      device, static_cast<std::int64_t>(chunks),
      [&](std::int64_t chunk) {
        const auto c = static_cast<std::size_t>(chunk);
        shown[c] = shown_of(binning, c);
        for_each_entry(shown[c], columns_,
                       [&](FacetId, int tile) { ++counts[c * bins + static_cast<std::size_t>(tile + 1)]; });
      },
      1);
  std::vector<std::size_t> starts(counts.size());
  std::size_t sum = 0;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    if (bin == 1) large_.resize(sum), sum = 0;
    if (bin >= 1) first_.push_back(sum);
    for (std::size_t c = 0; c < chunks; ++c) starts[c * bins + bin] = sum, sum += counts[c * bins + bin];
  }
  first_.push_back(sum);
  facets_.resize(sum);
  parallel_for_cpu(
      device, static_cast<std::int64_t>(chunks),
      [&](std::int64_t chunk) {
        std::size_t* next = starts.data() + static_cast<std::size_t>(chunk) * bins;
        for_each_entry(shown[static_cast<std::size_t>(chunk)], columns_,
                       [&](FacetId f, int tile) { (tile < 0 ? large_ : facets_)[next[tile + 1]++] = f; });
      },
      1);
}

std::span<const FacetId> TileBins::of(int tile) const {
  const auto t = static_cast<std::size_t>(tile);
  return std::span(facets_).subspan(first_[t], first_[t + 1] - first_[t]);
}

}  // namespace gabarit
