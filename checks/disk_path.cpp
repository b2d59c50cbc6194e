#include "checks/disk_path.h"

#include "checks/disk_coverage.h"
#include "checks/path_components.h"
#include "gpu/parallel_for.h"

namespace gabarit {

static std::vector<PathPiece> free_pieces(const OutlineFeatures& outline, double radius, const Device& device,
                                          const ReachGrid* reach) {
  const FeatureGrid grid(outline, radius, reach);
  const std::size_t points = outline.points.size();
  std::vector<std::vector<PathPiece>> by_feature(points + outline.edges.size());
  struct Kernel {
    const FeatureGrid* grid;
    std::vector<PathPiece>* out;
    std::size_t points;
    void operator()(std::int64_t i) const {
      const auto feature = static_cast<std::size_t>(i);
      if (feature < points) {
        free_arcs(*grid, static_cast<std::uint32_t>(feature), out[feature]);
      } else {
        free_lines(*grid, static_cast<std::uint32_t>(feature - points), out[feature]);
      }
    }
  };
  parallel_for(device.host(), static_cast<std::int64_t>(by_feature.size()),
               Kernel{&grid, by_feature.data(), points}, 32);
  std::vector<PathPiece> all;
  for (const auto& some : by_feature) all.insert(all.end(), some.begin(), some.end());
  return all;
}

DiskPath disk_path(const OutlineFeatures& outline, double radius, const Device& device,
                   const ReachGrid* reach) {
  DiskPath path;
  path.radius = radius;
  std::vector<PathPiece> all = free_pieces(outline, radius, device, reach);
  const std::vector<bool> reached = number_components(all, outline, radius);
  std::vector<std::uint32_t> number(reached.size(), 0);
  for (std::size_t c = 0; c < reached.size(); ++c) {
    if (reached[c]) number[c] = path.components++;
  }
  for (PathPiece& piece : all) {
    if (!reached[piece.component]) continue;
    piece.component = number[piece.component];
    path.pieces.push_back(piece);
  }
  return path;
}

}  // namespace gabarit
