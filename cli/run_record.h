// run.json: what differs from run to run, kept out of every other output.
#pragma once

#include <ctime>
#include <string>
#include <vector>

#include "cli/progress.h"

namespace gabarit {

struct RunRecord {
  std::time_t started = 0;
  int threads = 0;
  std::vector<std::string> command;
};

std::string run_json(const RunRecord& record, const std::vector<Stage>& stages);

}  // namespace gabarit
