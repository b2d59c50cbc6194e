// Where the files of an installed program lie: its rules, and the fonts of a bundle.
#pragma once

#include <filesystem>

namespace gabarit {

// share/gabarit beside the folder that the running program lies in; empty when there is none, as in a build
// folder.
std::filesystem::path installed_files();

}  // namespace gabarit
