#include "model/weld.h"

#include <array>
#include <bit>
#include <stdexcept>

namespace gabarit {

static std::size_t hash(const Vec3d& p) {
  // Adding 0 turns -0 into 0, so that both hash alike.
  std::uint64_t h = std::bit_cast<std::uint64_t>(p.x + 0.0) * 0x9E3779B97F4A7C15ULL;
  h = (std::rotl(h, 29) ^ std::bit_cast<std::uint64_t>(p.y + 0.0)) * 0xBF58476D1CE4E5B9ULL;
  h = (std::rotl(h, 29) ^ std::bit_cast<std::uint64_t>(p.z + 0.0)) * 0x94D049BB133111EBULL;
  return h ^ (h >> 32U);
}

VertexWeld::VertexWeld(std::vector<Vec3d>& vertices, std::size_t expected) : vertices_(&vertices) {
  slots_.assign(std::bit_ceil(std::max<std::size_t>(1024, expected + expected / 2)), 0);
  mask_ = slots_.size() - 1;
  vertices.reserve(expected);
}

void VertexWeld::add(std::span<const Vec3d> points, VertexId* numbers) {
  constexpr std::size_t batch = 64;
  std::array<std::size_t, batch> hashes{};
  for (std::size_t begin = 0; begin < points.size(); begin += batch) {
    const auto some = points.subspan(begin, std::min(batch, points.size() - begin));
    if ((vertices_->size() + some.size()) * 3 > slots_.size() * 2) grow();
    for (std::size_t i = 0; i < some.size(); ++i) {
      hashes[i] = hash(some[i]);
      __builtin_prefetch(&slots_[hashes[i] & mask_]);
    }
    for (std::size_t i = 0; i < some.size(); ++i)
      numbers[begin + i] = find_or_add(some[i], hashes[i] & mask_);
  }
}

VertexId VertexWeld::find_or_add(const Vec3d& point, std::size_t slot) {
  const bool finite = is_finite(point);
  for (; slots_[slot] != 0; slot = (slot + 1) & mask_) {
    if (finite && (*vertices_)[slots_[slot] - 1] == point) return slots_[slot] - 1;
  }
  if (vertices_->size() >= 0xFFFFFFFEU)
    throw std::length_error("the model has more than 4.29 thousand million vertices");
  vertices_->push_back(point);
  const auto number = static_cast<VertexId>(vertices_->size() - 1);
  if (finite) slots_[slot] = number + 1;
  return number;
}

void VertexWeld::grow() {
  slots_.assign(slots_.size() * 2, 0);
  mask_ = slots_.size() - 1;
  for (VertexId v = 0; v < vertices_->size(); ++v) {
    if (!is_finite((*vertices_)[v])) continue;
    std::size_t slot = hash((*vertices_)[v]) & mask_;
    while (slots_[slot] != 0) slot = (slot + 1) & mask_;
    slots_[slot] = v + 1;
  }
}

}  // namespace gabarit
