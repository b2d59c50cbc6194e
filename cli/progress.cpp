#include "cli/progress.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>
#include <unistd.h>

namespace gabarit {

static double seconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

Progress::Progress(bool shown) : shown_(shown) {}

void Progress::begin(const std::string& stage) {
  end();
  const std::lock_guard guard(mutex_);
  stage_ = stage;
  begun_ = drawn_ = Clock::now();
}

void Progress::update(double fraction) {
  if (!shown_) return;
  const std::lock_guard guard(mutex_);
  const Clock::time_point now = Clock::now();
  if (stage_.empty() || seconds(now - begun_) < 1 || seconds(now - drawn_) < 0.1) return;
  drawn_ = now;
  line_ = true;
  const double percent = fraction > 0 ? std::min(fraction, 1.0) * 100 : 0.0;
  std::fputs(fmt::format("\r\033[K{:.60} {:3.0f} %", stage_, percent).c_str(), stderr);
}

void Progress::clear_line() {
  if (line_) std::fputs("\r\033[K", stderr);
  line_ = false;
}

void Progress::end() {
  const std::lock_guard guard(mutex_);
  if (!stage_.empty()) stages_.push_back({stage_, seconds(Clock::now() - begun_)});
  stage_.clear();
  clear_line();
}

bool progress_is_visible() {
  const char* const terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::strcmp(terminal, "dumb") != 0;
}

}  // namespace gabarit
