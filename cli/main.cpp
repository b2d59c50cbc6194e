#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/messages.h"
#include "report/version.h"

namespace gabarit {

static int run(int argc, char** argv) {
  CLI::App app{"Checks CAD models against geometric safety rules."};
  app.name("gabarit");
  app.set_version_flag("--version", std::string("gabarit ") + program_version);
  app.require_subcommand(1);
  app.get_formatter()->column_width(26);
  const std::array commands{check_command(app),    measure_command(app), explain_command(app),
                            validate_command(app), info_command(app),    devices_command(app)};
  // Set last: commands inherit what stands here when they are added.
  app.footer(
      "Each command has its own --help. Exit codes: 0 clean, 1 violation, 2 bad input,\n"
      "3 undecided or not run, 70 internal error.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    throw UsageError{error.what()};
  }
  for (const Command& command : commands) {
    if (command.app->parsed()) return command.run();
  }
  return exit_bad_input;
}

}  // namespace gabarit

int main(int argc, char** argv) {
  using namespace gabarit;
  // A reader that goes away and a file that grows past its limit are answers of a write, not a sudden end.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return run(argc, argv);
  } catch (const UsageError& error) {
    print_error(error.message + "\nSee gabarit --help, or --help after a command.");
    return exit_bad_input;
  } catch (const std::bad_alloc&) {
    print_error("out of memory; nothing was written. Use a machine with more memory, or a coarser model.");
  } catch (const std::exception& error) {
    print_error(std::string("internal error: ") + error.what() +
                "\nThis is a fault of gabarit. Please report it with the command line and the files.");
  }
  return exit_internal_error;
}
