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

Progress::Progress(bool shown) {
  if (shown) drawing_ = std::jthread([this](const std::stop_token& stop) { draw_until(stop); });
}

Progress::~Progress() { end(); }

void Progress::begin(const std::string& stage) {
  end();
  const std::lock_guard guard(mutex_);
  stage_ = stage;
  fraction_ = 0;
  begun_ = Clock::now();
}

void Progress::update(double fraction) {
  const std::lock_guard guard(mutex_);
  fraction_ = std::clamp(fraction, 0.0, 1.0);
}

void Progress::draw_until(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    stopped_.wait_for(lock, stop, std::chrono::milliseconds(200), [] { return false; });
    if (!stop.stop_requested()) draw();
  }
}

void Progress::draw() {
  const double running = seconds(Clock::now() - begun_);
  if (stage_.empty() || running < 1) return;
  std::string text = fmt::format("\r\033[K{:.60} {:.0f} s", stage_, running);
  if (fraction_ > 0) text += fmt::format(" {:.0f} %", fraction_ * 100);
  std::fputs(text.c_str(), stderr);
  line_ = true;
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
