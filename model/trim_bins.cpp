#include "model/trim_bins.h"

#include "model/brep_trim.h"

namespace gabarit {
namespace {

constexpr std::uint32_t few_pieces = 8;

struct Layers {
  std::uint32_t low, high;
};
Layers layers_of(const FaceTrim& trim, const TrimPiece& piece) {
  return {trim_bin(trim, piece.a.v), trim_bin(trim, piece.b.v)};
}

// Entries of all lists together.
std::uint64_t entries(const FaceTrim& trim, const Brep& brep) {
  std::uint64_t sum = 0;
  for (std::uint32_t i = 0; i < trim.piece_count; ++i) {
    const Layers l = layers_of(trim, brep.trim_pieces[trim.first_piece + i]);
    sum += l.high - l.low + 1;
  }
  return sum;
}

}  // namespace

void sort_into_bins(FaceTrim& trim, Brep& brep) {
  if (trim.piece_count <= few_pieces) return;
  // Half as many layers as pieces; fewer when pieces are so long that the lists would grow with their square.
  trim.bin_count = trim.piece_count / 2;
  while (trim.bin_count > 1 && entries(trim, brep) > 4ULL * trim.piece_count) trim.bin_count /= 2;
  trim.first_bin = static_cast<std::uint32_t>(brep.trim_bins.size());
  std::vector<std::vector<std::uint32_t>> lists(trim.bin_count);
  for (std::uint32_t i = trim.first_piece; i < trim.first_piece + trim.piece_count; ++i) {
    const Layers l = layers_of(trim, brep.trim_pieces[i]);
    for (std::uint32_t bin = l.low; bin <= l.high; ++bin) lists[bin].push_back(i);
  }
  for (const auto& list : lists) {
    brep.trim_bins.push_back(static_cast<std::uint32_t>(brep.trim_listing.size()));
    brep.trim_listing.insert(brep.trim_listing.end(), list.begin(), list.end());
  }
  brep.trim_bins.push_back(static_cast<std::uint32_t>(brep.trim_listing.size()));
}

}  // namespace gabarit
