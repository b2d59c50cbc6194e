// Where the files of an installed program lie: its rules, and the fonts of a bundle.
#pragma once

#include <filesystem>
#include <string>

namespace gabarit {

// What tells where the running program lies.
struct ProgramTraces {
  std::filesystem::path link = "/proc/self/exe";  // to the program; certain where it can be read
  std::string called;                             // the first word of the command line
  std::string search;            // folders separated by `:`, where a word without a folder is looked for
  std::filesystem::path prefix;  // above bin and share, where this build was meant to go; may be empty
};

// Those of this process. `called`: main's argv[0], which may be null.
ProgramTraces program_traces(const char* called);

// share/gabarit beside the folder that the program lies in; empty when there is none, as in a build folder.
// What the link says is all that is looked at; where it cannot be read, as in a chroot without /proc, the
// program is looked for as a shell finds it, and then below the prefix.
std::filesystem::path installed_files(const ProgramTraces& traces);

}  // namespace gabarit
