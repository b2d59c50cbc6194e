#include <algorithm>
#include <array>
#include <csignal>
#include <exception>
#include <new>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/messages.h"
#include "gpu/device_error.h"
#include "report/installation.h"
#include "report/version.h"
#include "rules/nearest_name.h"

namespace gabarit {

static std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

static std::string question(const std::string& word, const std::vector<std::string>& known) {
  const auto nearest = nearest_name(word, known);
  return nearest ? fmt::format("; did you mean `{}`?", *nearest) : std::string();
}

// The parser's own words, or the nearest known name when an option is mistyped.
static UsageError usage_error(const CLI::App& app, const CLI::ParseError& error) {
  std::vector<const CLI::App*> parsed{&app};
  for (const CLI::App* const command : app.get_subcommands()) parsed.push_back(command);
  for (const CLI::App* const command : parsed) {
    if (command->get_allow_extras()) continue;
    for (const std::string& word : command->remaining()) {
      if (!word.starts_with('-')) continue;
      const std::string name = word.substr(0, word.find('='));
      return {fmt::format("`{}` has no option `{}`{}", command->get_name(), name,
                          question(name, option_names(*command)))};
    }
  }
  return {error.what()};
}

static void require_known_command(CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* const command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  const std::string all = fmt::format("{}", fmt::join(names, ", "));
  if (word.empty()) throw UsageError{"name a command: " + all};
  if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end()) return;
  throw UsageError{
      fmt::format("there is no command `{}`{}\nThe commands are: {}", word, question(word, names), all)};
}

static int run(int argc, char** argv) {
  CLI::App app{"Checks CAD models against geometric safety rules."};
  app.name("gabarit");
  app.set_version_flag("--version", std::string("gabarit ") + program_version);
  app.require_subcommand(1);
  app.get_formatter()->column_width(28);
  const std::filesystem::path installed = installed_files(program_traces(argc > 0 ? argv[0] : nullptr));
  const std::array commands{check_command(app, installed),    measure_command(app), explain_command(app),
                            validate_command(app, installed), info_command(app),    devices_command(app)};
  // Set last: commands inherit what stands here when they are added.
  app.footer(
      "Each command has its own --help. Exit codes: 0 clean, 1 violation, 2 bad input,\n"
      "3 undecided or not run, 70 internal error.");
  require_known_command(app, argc > 1 ? argv[1] : "");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    throw usage_error(app, error);
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
  } catch (const DeviceError& error) {
    print_error(std::string(error.what()) + "; choose --device cpu or auto");
    return exit_bad_input;
  } catch (const std::exception& error) {
    print_error(std::string("internal error: ") + error.what() +
                "\nThis is a fault of gabarit. Please report it with the command line and the files.");
  }
  return exit_internal_error;
}
