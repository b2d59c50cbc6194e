#include "examples/motorcycle/stl_stream.h"

#include <cstddef>
#include <cstring>
#include <string_view>

namespace gabarit::motorcycle {

// Little-endian on every machine.
static void put_word(unsigned char* to, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) to[i] = static_cast<unsigned char>(word >> (8 * i));
}

static void put_point(unsigned char* to, const Vec3f& p) {
  for (int axis = 0; axis < 3; ++axis) {
    const float coordinate = p[axis];
    std::uint32_t word = 0;
    std::memcpy(&word, &coordinate, sizeof word);
    put_word(to + std::ptrdiff_t{4} * axis, word);
  }
}

void write_stl_header(OutputFile& file, std::uint32_t facets) {
  constexpr std::string_view title = "Gabarit example: motorcycle, millimetres, x rearward, z up";
  std::array<unsigned char, 84> header{};
  std::memcpy(header.data(), title.data(), title.size());
  put_word(header.data() + 80, facets);
  file.write(header.data(), header.size());
}

void write_stl_facet(OutputFile& file, const std::array<Vec3f, 3>& corners) {
  const auto [a, b, c] = corners;
  std::array<unsigned char, 50> record{};
  put_point(record.data(), normalized(cross(b - a, c - a)));
  for (std::size_t i = 0; i < 3; ++i) put_point(record.data() + 12 * (i + 1), corners[i]);
  file.write(record.data(), record.size());
}

}  // namespace gabarit::motorcycle
