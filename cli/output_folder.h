// Whether outputs can be written, asked before hours of work and without touching anything.
#pragma once

#include <filesystem>

namespace gabarit {

// Throw UsageError with the reason. That nothing stands in the way now does not promise that the disk won't
// be full later: the writers look again.
void check_output_folder(const std::filesystem::path& folder);
void check_output_file(const std::filesystem::path& file);

}  // namespace gabarit
