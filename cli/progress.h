// How far a run is, on standard error when that is a terminal, and how long its stages took.
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <vector>

namespace gabarit {

struct Stage {
  std::string name;
  double seconds = 0;
};

class Progress {
 public:
  explicit Progress(bool shown);
  ~Progress() { end(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Ends the stage before it.
  void begin(const std::string& stage);
  // Of the stage, 0 to 1; from any thread. A line appears after the first second.
  void update(double fraction);
  void end();
  const std::vector<Stage>& stages() const { return stages_; }

 private:
  using Clock = std::chrono::steady_clock;
  void clear_line();

  const bool shown_;
  std::mutex mutex_;
  std::string stage_;  // empty between stages
  Clock::time_point begun_, drawn_;
  bool line_ = false;
  std::vector<Stage> stages_;
};

// Whether standard error is a terminal that a line can be drawn on again and again.
bool progress_is_visible();

}  // namespace gabarit
