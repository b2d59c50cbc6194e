// Fields and regions as numbers of which none may differ.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "checks/field.h"
#include "checks/region.h"

namespace gabarit {

using Bits = std::vector<std::uint64_t>;

inline void add(Bits& bits, double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); }
inline void add(Bits& bits, const Vec3d& p) { add(bits, p.x), add(bits, p.y), add(bits, p.z); }

inline Bits bits_of(const Field& field) {
  Bits bits;
  for (std::size_t i = 0; i < field.size(); ++i) {
    bits.push_back(field.facets[i]), bits.push_back(static_cast<std::uint64_t>(field.absence[i]));
    add(bits, field.value[i]), add(bits, field.lower[i]), add(bits, field.upper[i]);
    add(bits, field.at[i]), add(bits, field.contact[i]);
  }
  return bits;
}

inline Bits bits_of(const Region& region) {
  Bits bits;
  for (std::size_t f = 0; f < region.facets.size(); ++f) {
    bits.push_back(static_cast<std::uint64_t>(region.facets[f]));
    for (const Selected edge : region.edges[f]) bits.push_back(static_cast<std::uint64_t>(edge));
    add(bits, region.depth[f]);
  }
  for (const Trace& trace : region.traces) {
    for (const Vec3d& p : trace.points) add(bits, p);
  }
  return bits;
}

}  // namespace gabarit
