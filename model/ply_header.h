// The header of a PLY file (Turk, The PLY Polygon File Format, 1994): what the data behind it holds.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/result.h"

namespace gabarit {

enum class PlyFormat { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
std::size_t size_of(PlyType type);  // bytes, in the binary forms
inline bool is_integer(PlyType type) { return type < PlyType::float32; }

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count;  // of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;  // as announced
  std::vector<PlyProperty> properties;
  // The fewest bytes that one takes.
  std::uint64_t least_bytes(PlyFormat format) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;  // up to the data
  int lines = 0;
};

Result<PlyHeader> read_ply_header(std::string_view bytes, const std::string& file);

}  // namespace gabarit
