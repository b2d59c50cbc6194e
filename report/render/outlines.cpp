#include "report/render/outlines.h"

#include <algorithm>
#include <cmath>

namespace gabarit {
namespace {

constexpr float silhouette_ink = 0.80F;
constexpr float crease_ink = 0.42F;

float smooth_step(float from, float to, float value) {
  const float t = std::clamp((value - from) / (to - from), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

// Cosine of the angle between two facets as seen.
float cosine(PageNormal a, PageNormal b) {
  return static_cast<float>(a.x * b.x + a.y * b.y + a.z * b.z) / (127.0F * 127.0F);
}

// How far apart in depth two neighbouring samples are beyond what either surface's slope explains; `step` is
// the change of depth that a unit slope makes, in each normal's component along the step.
float unexplained(float dz, float slope_a, float slope_b) {
  return std::min(
      {std::abs(dz - slope_a), std::abs(dz - slope_b), std::abs(dz - 0.5F * (slope_a + slope_b))});
}

// Change of depth from a sample to its neighbour in the surface's plane.
float slope(PageNormal n, bool down) {
  const auto z = static_cast<float>(std::max<int>(n.z, 4));
  return (down ? static_cast<float>(n.y) : -static_cast<float>(n.x)) / z;
}

// Ink between two neighbouring samples, for the one and the other.
struct Ink {
  float a = 0, b = 0;
};

Ink between(const Tile& tile, std::size_t a, std::size_t b, bool down) {
  const FacetId f = tile.front.facet[a];
  const FacetId g = tile.front.facet[b];
  if (f == g) return {};
  // Behind the faint skin nothing is outlined.
  if (!tile.skin.empty() && (tile.skin[a] != no_facet || tile.skin[b] != no_facet)) return {};
  if (f == no_facet) return {0, silhouette_ink};
  if (g == no_facet) return {silhouette_ink, 0};
  const float dz = tile.front.depth[b] - tile.front.depth[a];
  const float jump = unexplained(dz, slope(tile.normal[a], down), slope(tile.normal[b], down));
  const float cliff = silhouette_ink * smooth_step(1.5F * samples_per_pixel, 8.0F * samples_per_pixel, jump);
  // Folds from about 20 degrees on, in full from 50.
  const float fold = crease_ink * smooth_step(0.06F, 0.36F, 1 - cosine(tile.normal[a], tile.normal[b]));
  return dz > 0 ? Ink{fold, std::max(fold, cliff)} : Ink{std::max(fold, cliff), fold};
}

// The strongest ink within one sample along a row (stride 1) or a column.
std::vector<std::uint8_t> spread(const std::vector<std::uint8_t>& ink, std::size_t stride) {
  std::vector<std::uint8_t> wide(ink);
  for (std::size_t i = stride; i + stride < ink.size(); ++i) {
    wide[i] = std::max({ink[i - stride], ink[i], ink[i + stride]});
  }
  return wide;
}

std::uint16_t inked(std::uint16_t light, float rest) {
  return static_cast<std::uint16_t>(static_cast<float>(light) * rest);
}

}  // namespace

void ink_outlines(Tile& tile) {
  std::vector<std::uint8_t> ink(samples_in_tile);
  const auto add = [&](std::size_t i, float amount) {
    ink[i] = std::max(ink[i], static_cast<std::uint8_t>(amount * 255.0F));
  };
  for (int y = 0; y + 1 < tile_samples; ++y) {
    for (int x = 0; x + 1 < tile_samples; ++x) {
      const std::size_t i = Tile::at(x, y);
      const Ink right = between(tile, i, i + 1, false);
      const Ink down = between(tile, i, i + tile_samples, true);
      add(i, std::max(right.a, down.a));
      add(i + 1, right.b);
      add(i + tile_samples, down.b);
    }
  }
  const std::vector<std::uint8_t> wide = spread(spread(ink, 1), tile_samples);
  for (std::size_t i = 0; i < samples_in_tile; ++i) {
    if (wide[i] == 0) continue;
    const bool bold = tile.cover[i] == Cover::facet || (tile.skin.empty() && tile.cover[i] == Cover::paper);
    const float rest = 1 - static_cast<float>(wide[i]) / 255.0F * (bold ? 1.0F : 0.4F);
    Light& light = tile.light[i];
    light = {inked(light.r, rest), inked(light.g, rest), inked(light.b, rest)};
  }
}

}  // namespace gabarit
