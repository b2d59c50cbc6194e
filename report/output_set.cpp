#include "report/output_set.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "report/earlier_run.h"

namespace gabarit {

namespace fs = std::filesystem;

OutputSet::OutputSet(fs::path folder) : folder_(std::move(folder)), staging_(folder_ / ".gabarit-partial") {
  try {
    create_folder();
    lock();
    for (const fs::directory_entry& left : fs::directory_iterator(staging_)) fs::remove_all(left.path());
  } catch (...) {
    if (lock_ >= 0) close(lock_);
    std::error_code ignored;
    for (auto it = created_.rbegin(); it != created_.rend(); ++it) fs::remove(*it, ignored);
    throw;
  }
}

void OutputSet::create_folder() {
  std::vector<fs::path> missing;
  for (fs::path p = folder_.lexically_normal(); !p.empty() && !fs::exists(p); p = p.parent_path()) {
    missing.push_back(p);
    if (p == p.parent_path()) break;
  }
  for (auto it = missing.rbegin(); it != missing.rend(); ++it) {
    if (fs::create_directory(*it)) created_.push_back(*it);
  }
  if (fs::create_directory(staging_)) created_.push_back(staging_);
}

// The lock goes with the process, so that a killed run does not lock out the next one. Where the file system
// knows no locks, there is none.
void OutputSet::lock() {
  lock_ = open(staging_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ >= 0 && (flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)) return;
  throw fs::filesystem_error("another run is writing here", folder_,
                             std::error_code(errno, std::generic_category()));
}

OutputSet::~OutputSet() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  if (!committed_) {
    // A folder into which somebody else has put something by now is not empty and stays.
    for (auto it = created_.rbegin(); it != created_.rend(); ++it) fs::remove(*it, ignored);
  }
  close(lock_);
}

void OutputSet::add(const std::string& name, const std::function<void(OutputFile&)>& write) {
  const fs::path place = staging_ / name;
  fs::create_directories(place.parent_path());
  OutputFile file(place);
  write(file);
  file.commit();
  names_.push_back(name);
}

void OutputSet::check_places() const {
  for (const std::string& name : names_) {
    const fs::path place = folder_ / name;
    if (fs::is_directory(place)) {
      throw fs::filesystem_error("cannot write", place, std::make_error_code(std::errc::is_a_directory));
    }
  }
}

void OutputSet::create_parents() const {
  for (const std::string& name : names_) fs::create_directories((folder_ / name).parent_path());
}

// results.json comes last: where it is, the set is complete.
void OutputSet::move_into_place() {
  const std::string last = "results.json";
  bool has_last = false;
  for (const std::string& name : names_) {
    if (name == last) {
      has_last = true;
    } else {
      fs::rename(staging_ / name, folder_ / name);
    }
  }
  if (has_last) fs::rename(staging_ / last, folder_ / last);
}

std::vector<std::string> OutputSet::commit() {
  check_places();
  // Once before anything is removed, to see that it can be done, and once for what the removal took away.
  create_parents();
  remove_earlier_run(folder_);
  create_parents();
  move_into_place();
  committed_ = true;
  return names_;
}

}  // namespace gabarit
