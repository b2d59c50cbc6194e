#include "checks/reach_proof.h"

#include <algorithm>
#include <cmath>

#include "checks/flood.h"
#include "gpu/distance_transform.h"

namespace gabarit {
namespace {

// In squares. A point lies within half a diagonal of the middle of its square; an outline or a path passes
// within half a square of one of the points that stand for it. Squares whose corners touch are connected, so
// on the way from one middle to the next half a diagonal is lost.
constexpr double half_diagonal = 0.70711;
constexpr double half_step = 0.5;
constexpr double rounding = 0.01;  // of single precision
constexpr double surely_free = half_diagonal + half_step + half_diagonal + rounding;
constexpr double beside = 2;  // squares that are no further from the boundary are looked at

// Places of the path no further apart than a square.
void mark(const PathPiece& piece, double radius, const CellGrid& grid, std::vector<std::uint8_t>& cells) {
  const double size =
      piece.arc ? radius * (piece.to_angle - piece.from_angle) : length(piece.to - piece.from);
  const auto steps = static_cast<std::int64_t>(std::ceil(size / grid.size)) + 1;
  for (std::int64_t i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(steps);
    const double angle = piece.from_angle + t * (piece.to_angle - piece.from_angle);
    const Point2 p = piece.arc ? piece.centre + Point2{std::cos(angle), std::sin(angle)} * radius
                               : piece.from + (piece.to - piece.from) * t;
    cells[static_cast<std::size_t>(grid.cell(p))] = 1;
  }
}

}  // namespace

std::vector<std::uint8_t> missed_by(const DiskPath& path, const ReachGrid& reach, double gap,
                                    const Device& device) {
  const CellGrid& grid = reach.grid();
  const std::vector<float>& outline = reach.outline_distance();
  std::vector<std::uint8_t> cells(outline.size(), 0);
  for (const PathPiece& piece : path.pieces) mark(piece, path.radius, grid, cells);
  std::vector<float> from_path(outline.size());
  distance_transform(device, grid, cells, from_path);

  const double least = path.radius + surely_free * grid.size;
  cells = flood(grid, outline, least);
  bool any = false;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto distance = static_cast<double>(outline[i]);
    // A column here can go straight to what is nearest until it touches: there the path must be.
    const double way = distance - path.radius + (2 * half_diagonal + half_step + rounding) * grid.size + gap;
    cells[i] =
        cells[i] != 0 && distance <= least + beside * grid.size && static_cast<double>(from_path[i]) > way;
    any = any || cells[i] != 0;
  }
  if (!any) return {};
  distance_transform(device, grid, cells, from_path);
  std::vector<std::uint8_t> facets(reach.reached().size(), 0);
  reach.outlines().near(from_path, least + (beside + half_diagonal) * grid.size, facets);
  return facets;
}

}  // namespace gabarit
