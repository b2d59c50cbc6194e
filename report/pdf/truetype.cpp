#include "report/pdf/truetype.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <string_view>

namespace gabarit::pdf {

namespace {

// Big-endian numbers at places of a file; `good` turns false where there is nothing.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : stream_(file, std::ios::binary) {
    std::error_code error;
    size_ = std::filesystem::file_size(file, error);
    good_ = !error && stream_.good();
  }
  std::uint32_t number(std::uint64_t at, int bytes) {
    std::array<char, 4> buffer{};
    stream_.seekg(static_cast<std::streamoff>(at));
    stream_.read(buffer.data(), bytes);
    good_ = good_ && stream_.good();
    std::uint32_t value = 0;
    for (int i = 0; i < bytes; ++i)
      value = value << 8 | static_cast<unsigned char>(buffer[static_cast<std::size_t>(i)]);
    return value;
  }
  bool holds(std::uint64_t at, std::uint64_t bytes) const { return at <= size_ && bytes <= size_ - at; }
  bool good() const { return good_; }

 private:
  std::ifstream stream_;
  std::uint64_t size_ = 0;
  bool good_ = false;
};

struct Table {
  std::uint32_t at = 0, bytes = 0;
};

constexpr std::uint32_t tag(std::string_view name) {
  std::uint32_t value = 0;
  for (const char c : name) value = value << 8 | static_cast<unsigned char>(c);
  return value;
}

using Tables = std::map<std::uint32_t, Table>;

// Empty when one of them lies outside the file.
Tables read_tables(Reader& reader, std::uint64_t start) {
  Tables tables;
  const std::uint32_t count = reader.number(start + 4, 2);
  for (std::uint32_t i = 0; reader.good() && i < count; ++i) {
    const std::uint64_t entry = start + 12 + 16 * std::uint64_t{i};
    const Table table{reader.number(entry + 8, 4), reader.number(entry + 12, 4)};
    if (!reader.holds(table.at, table.bytes)) return {};
    tables[reader.number(entry, 4)] = table;
  }
  return tables;
}

// A table for the basic plane (platform 3, encoding 1) in segments: format 4.
bool has_unicode(Reader& reader, const Table& cmap) {
  const std::uint32_t count = reader.number(cmap.at + 2ULL, 2);
  for (std::uint32_t i = 0; reader.good() && i < count; ++i) {
    const std::uint64_t entry = cmap.at + 4 + 8 * std::uint64_t{i};
    const std::uint32_t platform = reader.number(entry, 2), encoding = reader.number(entry + 2, 2);
    const std::uint64_t place = std::uint64_t{cmap.at} + reader.number(entry + 4, 4);
    if (platform == 3 && encoding == 1 && reader.good() && reader.holds(place, 16))
      return reader.number(place, 2) == 4;
  }
  return false;
}

}  // namespace

bool is_embeddable(const std::filesystem::path& font) {
  Reader reader(font);
  if (!reader.good() || !reader.holds(0, 16)) return false;
  std::uint64_t start = 0;
  if (reader.number(0, 4) == tag("ttcf")) start = reader.number(12, 4);
  const std::uint32_t kind = reader.number(start, 4);
  if (!reader.good() || (kind != 0x00010000 && kind != tag("true"))) return false;
  const Tables tables = read_tables(reader, start);
  for (const char* const needed : {"head", "maxp", "hhea", "hmtx", "cmap", "loca", "glyf", "name", "OS/2"}) {
    if (!tables.contains(tag(needed))) return false;
  }
  return has_unicode(reader, tables.at(tag("cmap"))) && reader.good();
}

}  // namespace gabarit::pdf
