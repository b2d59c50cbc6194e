// What an earlier run left in an output folder: beside new results it would be read as theirs.
#pragma once

#include <filesystem>

namespace gabarit {

// Removes the outputs of an earlier run, and nothing else: files are known by name and by what they begin
// with, and those of a name that others use too (report.pdf, …) only go when results.json beside them is
// ours. Throws filesystem_error when something can't be removed.
void remove_earlier_run(const std::filesystem::path& folder);

}  // namespace gabarit
