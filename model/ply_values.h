// The values behind a PLY header, one after the other, whichever of the three forms they are written in.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "model/number_word.h"
#include "model/ply_header.h"
#include "model/text_lines.h"

namespace gabarit {

// Words; a line that begins with "comment" is passed over, as some writers put it among the data.
class PlyWords {
 public:
  PlyWords(std::string_view data, int header_lines) : lines_(data), header_lines_(header_lines) {}

  // False when there is no value of this type here; doubles hold every type.
  bool next(PlyType type, double& value) {
    while (word_ = next_word(line_), word_.empty()) {
      if (!lines_.next(line_)) return false;
      std::string_view rest = line_;
      if (next_word(rest) == "comment") line_ = {};
    }
    if (!is_integer(type)) return read_number(word_, value);
    std::int64_t integer = 0;
    if (!read_integer(word_, integer)) return false;
    value = static_cast<double>(integer);
    return true;
  }
  std::uint64_t bytes_left() const { return line_.size() + lines_.rest().size(); }
  // The fewest bytes of one value: a digit and a blank.
  static std::uint64_t bytes_of(PlyType) { return 2; }
  int line() const { return header_lines_ + lines_.number(); }
  // What stands where a value should, empty at the end.
  std::string_view found() const { return word_; }

  // Whether anything but comments follows.
  bool has_more() {
    double ignored = 0;
    next(PlyType::float64, ignored);
    return !word_.empty();
  }

 private:
  Lines lines_;
  std::string_view line_, word_;
  int header_lines_;
};

template <std::endian Order>
class PlyBytes {
 public:
  PlyBytes(std::string_view data, int) : data_(data) {}

  bool next(PlyType type, double& value) {
    if (data_.size() < size_of(type)) return data_ = {}, false;
    switch (type) {
      case PlyType::int8: value = take<std::int8_t>(); break;
      case PlyType::uint8: value = take<std::uint8_t>(); break;
      case PlyType::int16: value = take<std::int16_t>(); break;
      case PlyType::uint16: value = take<std::uint16_t>(); break;
      case PlyType::int32: value = take<std::int32_t>(); break;
      case PlyType::uint32: value = take<std::uint32_t>(); break;
      case PlyType::float32: value = take<float>(); break;
      case PlyType::float64: value = take<double>(); break;
    }
    return true;
  }
  std::uint64_t bytes_left() const { return data_.size(); }
  static std::uint64_t bytes_of(PlyType type) { return size_of(type); }
  int line() const { return 0; }
  std::string_view found() const { return {}; }
  // A line end behind the data is no data.
  bool has_more() const { return data_.find_first_not_of("\r\n") != std::string_view::npos; }

 private:
  template <class T>
  T take() {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), data_.data(), sizeof(T));
    if constexpr (Order != std::endian::native) std::reverse(raw.begin(), raw.end());
    data_.remove_prefix(sizeof(T));
    return std::bit_cast<T>(raw);
  }

  std::string_view data_;
};

}  // namespace gabarit
