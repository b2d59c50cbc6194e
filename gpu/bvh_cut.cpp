#include "gpu/bvh_cut.h"

#include <cstring>

namespace gabarit {

LaneBox lanes_of(const BoxedPrimitive& b) {
  static_assert(sizeof(BoxedPrimitive) == 7 * sizeof(float));
  LaneBox box;
  std::memcpy(&box.lo, &b.box.min, sizeof box.lo);
  std::memcpy(&box.hi, &b.box.max, sizeof box.hi);
  return box;
}

float half_area(const Box3f& box) {
  const Vec3f e = box.extent();
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

CentreBox::CentreBox(std::span<const BoxedPrimitive> boxes) {
  for (const BoxedPrimitive& b : boxes) {
    const LaneBox lanes = lanes_of(b);
    const Lanes twice = lanes.lo + lanes.hi;
    box.add({twice, twice});
  }
}

Bins::Bins(const CentreBox& centres) : from_(centres.box.lo) {
  for (int k = 0; k < 3; ++k) {
    const float extent = centres.box.hi[k] - centres.box.lo[k];
    scale_[k] = extent > 0 ? static_cast<float>(count) * 0.9999F / extent : 0.0F;
  }
}

Bins::Numbers Bins::numbers(const LaneBox& box) const {
  const Lanes at = (box.lo + box.hi - from_) * scale_;
  constexpr float most = count - 1;
  const Lanes first{0, 0, 0, 0}, last{most, most, most, most};
  const Lanes above = at > first ? at : first;
  return __builtin_convertvector(above < last ? above : last, Numbers);
}

void Bins::add(std::span<const BoxedPrimitive> boxes) {
  for (const BoxedPrimitive& b : boxes) {
    const LaneBox box = lanes_of(b);
    const Numbers number = numbers(box);
    for (std::size_t k = 0; k < 3; ++k) bins_[k][static_cast<std::size_t>(number[k])].add({box, 1});
  }
}

void Bins::add(const Bins& other) {
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < count; ++i) bins_[k][i].add(other.bins_[k][i]);
}

Cut Bins::cheapest_cut(std::uint32_t leaves) const {
  Cut cut;
  for (std::size_t k = 0; k < 3; ++k) keep_cheapest(k, leaves, cut);
  return cut;
}

void Bins::keep_cheapest(std::size_t axis, std::uint32_t leaves, Cut& best) const {
  const std::array<Bin, count>& bins = bins_[axis];
  std::array<Bin, count> right;
  Bin sum;
  for (std::size_t i = count; i-- > 0;) sum.add(bins[i]), right[i] = sum;
  sum = {};
  for (std::size_t i = 0; i + 1 < count; ++i) {
    sum.add(bins[i]);
    const Bin& other = right[i + 1];
    if (bins[i].count == 0 || other.count == 0) continue;
    if (leaves_for(sum.count) + leaves_for(other.count) > leaves) continue;
    const float cost = half_area(sum.box.box()) * static_cast<float>(sum.count) +
                       half_area(other.box.box()) * static_cast<float>(other.count);
    if (cost < best.cost) best = {cost, axis, static_cast<int>(i), sum.box.box(), other.box.box()};
  }
}

}  // namespace gabarit
