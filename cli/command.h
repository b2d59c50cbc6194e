// A subcommand: its options, and what it does when it is chosen.
#pragma once

#include <filesystem>
#include <functional>

#include <CLI/CLI.hpp>

namespace gabarit {

struct Command {
  CLI::App* app = nullptr;   // how it is written on the command line
  std::function<int()> run;  // gives the exit code
};

// Each adds its subcommand to `app`; one file a subcommand. `installed`: what came with the program (see
// report/installation.h); may be empty.
Command check_command(CLI::App& app, const std::filesystem::path& installed);
Command measure_command(CLI::App& app);
Command explain_command(CLI::App& app);
Command validate_command(CLI::App& app, const std::filesystem::path& installed);
Command info_command(CLI::App& app);
Command devices_command(CLI::App& app);

}  // namespace gabarit
