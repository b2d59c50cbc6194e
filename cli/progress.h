// How far a run is, on standard error when that is a terminal, and how long its stages took.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace gabarit {

struct Stage {
  std::string name;
  double seconds = 0;
};

class Progress {
 public:
  // When shown, a thread of its own draws a line for every stage that takes more than a second, whether or
  // not the stage says how far it is.
  explicit Progress(bool shown);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Ends the stage before it.
  void begin(const std::string& stage);
  // Of the stage, 0 to 1; from any thread.
  void update(double fraction);
  void end();
  const std::vector<Stage>& stages() const { return stages_; }

 private:
  using Clock = std::chrono::steady_clock;
  void draw_until(const std::stop_token& stop);
  void draw();
  void clear_line();

  std::mutex mutex_;
  std::string stage_;  // empty between stages
  double fraction_ = 0;
  Clock::time_point begun_;
  bool line_ = false;
  std::vector<Stage> stages_;
  std::condition_variable_any stopped_;
  std::jthread drawing_;  // the last member: it uses the others
};

// Whether standard error is a terminal that a line can be drawn on again and again.
bool progress_is_visible();

}  // namespace gabarit
