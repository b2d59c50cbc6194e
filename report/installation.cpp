#include "report/installation.h"

#include <cstdlib>
#include <sstream>

#include <unistd.h>

#include "report/version.h"

namespace gabarit {

namespace fs = std::filesystem;

// Below the folder above bin and share.
static fs::path share_below(const fs::path& prefix) {
  std::error_code error;
  const fs::path folder = prefix / "share/gabarit";
  return !prefix.empty() && fs::is_directory(folder, error) ? folder : fs::path();
}

static bool is_program(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) && access(file.c_str(), X_OK) == 0;
}

// As a shell finds it; an empty folder of the list is the current one.
static fs::path found_as_called(const ProgramTraces& traces) {
  if (traces.called.empty()) return {};
  if (traces.called.find('/') != std::string::npos) return is_program(traces.called) ? traces.called : "";
  std::istringstream list(traces.search);
  for (std::string folder; std::getline(list, folder, ':');) {
    fs::path file = fs::path(folder.empty() ? "." : folder) / traces.called;
    if (is_program(file)) return file;
  }
  return {};
}

ProgramTraces program_traces(const char* called) {
  const char* const search = std::getenv("PATH");
  return {.called = called != nullptr ? called : "",
          .search = search != nullptr ? search : "",
          .prefix = install_prefix};
}

fs::path installed_files(const ProgramTraces& traces) {
  std::error_code error;
  if (const fs::path program = fs::read_symlink(traces.link, error); !error)
    return share_below(program.parent_path().parent_path());
  const fs::path found = fs::canonical(found_as_called(traces), error);
  if (fs::path share = share_below(found.parent_path().parent_path()); !error && !share.empty()) return share;
  return share_below(traces.prefix);
}

}  // namespace gabarit
