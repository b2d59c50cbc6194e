#include "report/output_file.h"

#include <cerrno>
#include <system_error>

#include <unistd.h>

namespace gabarit {

[[noreturn]] static void fail(const std::filesystem::path& place) {
  throw std::filesystem::filesystem_error("cannot write", place,
                                          std::error_code(errno, std::generic_category()));
}

OutputFile::OutputFile(std::filesystem::path place) : place_(std::move(place)), temporary_(place_) {
  temporary_ += ".partial";
  file_ = std::fopen(temporary_.c_str(), "wb");
  if (file_ == nullptr) fail(place_);
  // Large outputs are written in small records: a large buffer saves most of the calls to the system.
  std::setvbuf(file_, nullptr, _IOFBF, std::size_t{1} << 20);
}

OutputFile::~OutputFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void OutputFile::write(const void* bytes, std::size_t count) {
  if (std::fwrite(bytes, 1, count, file_) != count) fail(place_);
}

void OutputFile::commit() {
  if (std::fflush(file_) != 0 || fsync(fileno(file_)) != 0) fail(place_);
  std::FILE* const closing = file_;
  file_ = nullptr;
  if (std::fclose(closing) != 0 || std::rename(temporary_.c_str(), place_.c_str()) != 0) {
    const int reason = errno;
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
    errno = reason;
    fail(place_);
  }
}

}  // namespace gabarit
