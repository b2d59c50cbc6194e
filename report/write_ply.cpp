#include "report/write_ply.h"

#include <array>
#include <cstring>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace gabarit {

// A record of fixed size, filled from front to back in little-endian order.
template <std::size_t size>
class Record {
 public:
  void put(std::uint8_t byte) { bytes_[used_++] = byte; }
  void put(std::uint32_t word) {
    for (unsigned i = 0; i < 4; ++i) put(static_cast<std::uint8_t>(word >> (8 * i)));
  }
  void put(double number) {
    std::uint64_t word = 0;
    std::memcpy(&word, &number, sizeof word);
    for (unsigned i = 0; i < 8; ++i) put(static_cast<std::uint8_t>(word >> (8 * i)));
  }
  void flush(OutputFile& file) {
    file.write(bytes_.data(), used_);
    used_ = 0;
  }

 private:
  std::array<std::uint8_t, size> bytes_{};
  std::size_t used_ = 0;
};

static std::string header(const FieldView& view) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nelement face {}\nproperty list uchar int vertex_indices\n"
      "property double value\nproperty double lower\nproperty double upper\nproperty uchar selected\n"
      "property uchar verdict\nend_header\n",
      view.title, view.mesh->vertices.size(), view.mesh->facet_count());
}

static void put_measured(const FieldView& view, std::size_t entry, Record<64>& record) {
  const Field& field = *view.field;
  record.put(field.value[entry] * view.factor);
  record.put(field.lower[entry] * view.factor);
  record.put(field.upper[entry] * view.factor);
}

void write_ply(const FieldView& view, OutputFile& file) {
  const TriangleMesh& mesh = *view.mesh;
  if (mesh.vertices.size() > std::numeric_limits<std::int32_t>::max()) {
    throw std::length_error("too many vertices for PLY");
  }
  file.write(header(view));
  Record<64> record;
  for (const Vec3d& p : mesh.vertices) {
    record.put(p.x), record.put(p.y), record.put(p.z);
    record.flush(file);
  }
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::size_t entry = 0;
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    record.put(std::uint8_t{3});
    for (const VertexId v : mesh.facets[f]) record.put(v);
    const bool measured = entry < view.field->size() && view.field->facets[entry] == f;
    if (measured) {
      put_measured(view, entry, record);
    } else {
      record.put(none), record.put(none), record.put(none);
    }
    const auto& selected = view.region->facets;
    record.put(static_cast<std::uint8_t>(f < selected.size() ? selected[f] : Selected::no));
    const bool judged = measured && view.verdicts != nullptr && entry < view.verdicts->size();
    record.put(static_cast<std::uint8_t>(judged ? (*view.verdicts)[entry] : FacetVerdict::not_examined));
    record.flush(file);
    entry += measured ? 1 : 0;
  }
}

}  // namespace gabarit
