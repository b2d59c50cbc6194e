// Runs the built program as a user would.
#pragma once

#include <string>
#include <vector>

namespace gabarit {

struct Ending {
  int exit = -1;         // 128 + the signal when one ended it
  std::string out, err;  // what it printed
  long peak_memory = 0;  // bytes
};

struct RunOptions {
  std::string program = {};               // instead of the one that was built
  std::string folder = ".";               // to run in
  std::string before = {};                // shell commands in front, such as "ulimit -f 8"
  std::string out_to = {};                // a file for standard output instead of `out`
  std::vector<std::string> through = {};  // a command that runs it, such as {"env", "TERM=xterm"}
};

Ending run_gabarit(const std::vector<std::string>& arguments, const RunOptions& options = {});

}  // namespace gabarit
