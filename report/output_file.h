// A file that appears whole or not at all.
#pragma once

#include <cstdio>
#include <filesystem>
#include <span>
#include <string>

namespace gabarit {

// Writes to a temporary name in the same folder; commit() flushes, syncs and renames. Destroyed without
// commit, it leaves nothing. Throws std::filesystem::filesystem_error with the reason (no space, no
// permission).
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path place);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(const void* bytes, std::size_t count);
  void write(const std::string& text) { write(text.data(), text.size()); }
  void commit();

 private:
  std::filesystem::path place_, temporary_;
  std::FILE* file_ = nullptr;
};

}  // namespace gabarit
