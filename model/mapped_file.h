// A file's bytes, mapped read-only: nothing is copied, the size is known before anything is allocated.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "model/result.h"

namespace gabarit {

class MappedFile {
 public:
  // The error says what the system says: no such file, a folder, no permission.
  static Result<MappedFile> open(const std::filesystem::path& file);
  MappedFile(MappedFile&& other) noexcept : data_(other.data_), size_(other.size_) {
    other.data_ = nullptr, other.size_ = 0;
  }
  MappedFile& operator=(MappedFile&&) = delete;
  ~MappedFile();

  std::span<const std::uint8_t> bytes() const { return {data_, size_}; }
  std::string_view text() const { return {reinterpret_cast<const char*>(data_), size_}; }

 private:
  MappedFile(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  const std::uint8_t* data_;
  std::size_t size_;
};

}  // namespace gabarit
