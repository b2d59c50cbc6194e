#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>

#include <fmt/format.h>

#include "model/load_stl.h"
#include "model/weld.h"

namespace gabarit {

static constexpr std::size_t header_bytes = 84;
static constexpr std::size_t facet_bytes = 50;

static std::uint32_t announced_facets(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);  // little-endian, as every machine this runs on
  return count;
}

static bool has_word(std::string_view text, std::string_view word) {
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

bool has_announced_size(std::string_view bytes) {
  return bytes.size() >= header_bytes &&
         bytes.size() == header_bytes + facet_bytes * std::size_t{announced_facets(bytes)};
}

StlKind stl_kind(std::string_view bytes) {
  if (has_announced_size(bytes)) return StlKind::binary;
  const std::string_view start = bytes.substr(0, 4096);
  const bool text = start.find('\0') == std::string_view::npos;
  if (text && (has_word(start, "solid") || has_word(start, "facet"))) return StlKind::ascii;
  // Text with a damaged byte in it: the reader says where.
  if (begins_as_ascii_stl(start) && has_word(start, "normal") && has_word(start, "vertex"))
    return StlKind::ascii;
  return bytes.size() >= header_bytes && !text ? StlKind::binary : StlKind::neither;
}

static Diagnostics check_size(std::string_view bytes, const std::string& name, Model& model) {
  const std::size_t announced = announced_facets(bytes);
  const std::size_t present = (bytes.size() - header_bytes) / facet_bytes;
  const std::size_t rest = (bytes.size() - header_bytes) % facet_bytes;
  if (announced > present) {
    return {{.file = name,
             .message = fmt::format(
                 "the header announces {} facets, the file ends after {}: it is cut short; export it again",
                 announced, present)}};
  }
  if (announced < present) {
    return {{.file = name,
             .message = fmt::format(
                 "the header announces {} facets, the file holds {}: the header is wrong; export it again",
                 announced, present)}};
  }
  if (announced > most_facets) {
    return {{.file = name,
             .message = fmt::format("has {} facets, {} are the most that can be numbered; split the model",
                                    announced, most_facets)}};
  }
  if (rest != 0) {
    model.warnings.push_back({.level = Diagnostic::Level::warning,
                              .file = name,
                              .message = fmt::format("{} bytes after the last facet were not read", rest)});
  }
  return {};
}

Diagnostics load_binary_stl(std::string_view bytes, const std::string& name, double scale, Model& model) {
  if (Diagnostics errors = check_size(bytes, name, model); !errors.empty()) return errors;
  const std::size_t count = announced_facets(bytes);
  TriangleMesh& mesh = model.mesh;
  model.format = "binary STL";
  model.bodies = {"solid 1"};
  mesh.facets.resize(count);
  VertexWeld weld(mesh.vertices, count / 2 + 16);
  constexpr std::size_t batch = 256;
  std::array<Vec3d, 3 * batch> points;
  for (std::size_t begin = 0; begin < count; begin += batch) {
    const std::size_t some = std::min(batch, count - begin);
    for (std::size_t i = 0; i < 3 * some; ++i) {
      std::array<float, 3> xyz{};
      std::memcpy(xyz.data(), bytes.data() + header_bytes + (begin + i / 3) * facet_bytes + 12 + (i % 3) * 12,
                  sizeof xyz);
      points[i] = Vec3d{xyz[0], xyz[1], xyz[2]} * scale;
    }
    weld.add({points.data(), 3 * some}, mesh.facets[begin].data());
  }
  return {};
}

}  // namespace gabarit
