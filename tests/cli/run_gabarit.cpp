#include "tests/cli/run_gabarit.h"

#include <cstdlib>
#include <stdexcept>

#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/temporary_folder.h"

namespace gabarit {

// Both streams go to files: no pipe can fill up and block.
Ending run_gabarit(const std::vector<std::string>& arguments, const RunOptions& options) {
  const TemporaryFolder folder;
  const std::string err = folder / "err";
  const std::string out = options.out_to.empty() ? (folder / "out").string() : options.out_to;
  std::string script = "cd \"$1\" || exit 126; out=$2; err=$3; shift 3; " + options.before;
  script += "\nexec \"$@\" >\"$out\" 2>\"$err\" </dev/null";
  std::vector<std::string> words{"/bin/sh", "-c", script, "sh", options.folder, out, err};
  words.insert(words.end(), options.through.begin(), options.through.end());
  words.push_back(options.program.empty() ? GABARIT_PROGRAM : options.program);
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawn(&child, "/bin/sh", nullptr, nullptr, argv.data(), environ) != 0)
    throw std::runtime_error("the program could not be started");
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, 0, &usage) < 0) {
  }
  return {.exit = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status),
          .out = options.out_to.empty() ? content(out) : "",
          .err = content(err),
          .peak_memory = usage.ru_maxrss * 1024};
}

}  // namespace gabarit
