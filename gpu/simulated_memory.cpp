#include "gpu/simulated_memory.h"

#include <map>
#include <mutex>

#include <sys/mman.h>

namespace gabarit {
namespace {

// Of the process: a pointer into any of it may be followed by any kernel.
struct Pages {
  std::mutex guard;
  std::map<void*, std::size_t> bytes;
  int users = 0;

  int rights() const { return users > 0 ? PROT_READ | PROT_WRITE : PROT_NONE; }
  void protect() {
    for (const auto& [data, size] : bytes) static_cast<void>(mprotect(data, size, rights()));
  }
  static Pages& all() {
    static Pages pages;
    return pages;
  }
};

}  // namespace

void* allocate_simulated(std::size_t bytes) {
  Pages& pages = Pages::all();
  const std::lock_guard lock(pages.guard);
  void* const data = mmap(nullptr, bytes, pages.rights(), MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (data == MAP_FAILED) return nullptr;
  pages.bytes[data] = bytes;
  return data;
}

void release_simulated(void* data) {
  Pages& pages = Pages::all();
  const std::lock_guard lock(pages.guard);
  const auto place = pages.bytes.find(data);
  if (place == pages.bytes.end()) return;
  munmap(data, place->second);
  pages.bytes.erase(place);
}

SimulatedAccess::SimulatedAccess() {
  Pages& pages = Pages::all();
  const std::lock_guard lock(pages.guard);
  if (pages.users++ == 0) pages.protect();
}

SimulatedAccess::~SimulatedAccess() {
  Pages& pages = Pages::all();
  const std::lock_guard lock(pages.guard);
  if (--pages.users == 0) pages.protect();
}

}  // namespace gabarit
