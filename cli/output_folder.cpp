#include "cli/output_folder.h"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <unistd.h>

#include "cli/messages.h"

namespace gabarit {

namespace fs = std::filesystem;

void check_output_folder(const fs::path& folder) {
  if (folder.empty()) throw UsageError{"--out is empty: name a place for the outputs"};
  std::error_code ignored;
  fs::path there = fs::absolute(folder).lexically_normal();
  while (!fs::exists(there, ignored) && there != there.parent_path()) there = there.parent_path();
  if (!fs::is_directory(there, ignored)) {
    throw UsageError{fmt::format("--out {}: {} is not a folder", folder.string(), there.string())};
  }
  if (access(there.c_str(), W_OK | X_OK) != 0) {
    throw UsageError{fmt::format("--out {}: cannot write to {}: {}", folder.string(), there.string(),
                                 std::strerror(errno))};
  }
}

void check_output_file(const fs::path& file) {
  if (file.empty()) throw UsageError{"--out is empty: name a place for the output"};
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) throw UsageError{fmt::format("--out {}: is a folder", file.string())};
  const fs::path folder = fs::absolute(file).parent_path();
  if (!fs::is_directory(folder, ignored)) {
    throw UsageError{fmt::format("--out {}: there is no folder {}", file.string(), folder.string())};
  }
  check_output_folder(folder);
}

}  // namespace gabarit
