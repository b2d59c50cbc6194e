#include <cstdlib>
#include <memory>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "cli/check_options.h"
#include "cli/command.h"
#include "cli/devices.h"
#include "cli/messages.h"
#include "cli/on_device.h"
#include "cli/output_folder.h"
#include "cli/rule_file.h"
#include "cli/run_record.h"
#include "report/terminal.h"
#include "rules/engine.h"

namespace gabarit {

// All errors of all files are printed before anything is refused.
static std::optional<std::vector<RuleSet>> read_all_rules(const CheckOptions& options) {
  std::vector<RuleSet> sets;
  bool fine = true;
  for (const std::string& file : options.rules) {
    Result<RuleSet> set = read_named_rules(file, options.installed);
    if (set) {
      sets.push_back(std::move(*set));
    } else {
      print(set.error());
      fine = false;
    }
  }
  if (!fine) return std::nullopt;
  const Diagnostics in_the_way = check_selection(sets, options.only);
  print(in_the_way);
  return in_the_way.empty() ? std::optional(std::move(sets)) : std::nullopt;
}

static Outcome run_rules(const Model& model, const std::vector<RuleSet>& sets, const CheckOptions& options,
                         const Device& device, Progress& progress) {
  std::string current;
  EngineOptions engine;
  engine.sag = options.model.sag_length();
  engine.only = options.only;
  engine.progress = [&](const std::string& rule, double fraction) {
    if (rule != current) progress.begin(current = rule);
    progress.update(fraction);
  };
  progress.begin("rules");
  Outcome outcome = on_device(
      device, options.device == "cuda",
      [&](const Device& where) {
        engine.device = where;
        return run(model, sets, engine);
      },
      [](const std::string& trouble) { print_error(trouble + "; the CPU computes all of it instead"); });
  progress.end();
  return outcome;
}

static TerminalStyle terminal_style() {
  const char* const plain = std::getenv("NO_COLOR");
  const bool wanted = plain == nullptr || *plain == '\0';
  return {.colour = wanted && isatty(STDOUT_FILENO) == 1};
}

static std::string list_of_files(const std::string& folder, const std::vector<std::string>& files) {
  std::string text = fmt::format("\nwritten to {}:\n", folder);
  std::size_t small = 0;
  // The files of single rules may be many; their folders say enough.
  for (const std::string& file : files) {
    if (file.find('/') == std::string::npos) {
      text += fmt::format("  {}\n", file);
    } else {
      ++small;
    }
  }
  return small == 0
             ? text
             : text + fmt::format("  and {} files of single rules in violations/ and fields/\n", small);
}

// The evidence is written by now: a full disk behind standard output does not change the verdict.
static void print_summary(const std::string& text) {
  try {
    print_result(text);
  } catch (const UsageError& error) {
    print_error(error.message + "; the files are complete");
  }
}

static int check_model(const Model& model, const std::vector<RuleSet>& sets, const CheckOptions& options,
                       const Device& device, RunRecord record, Progress& progress) {
  const Outcome outcome = run_rules(model, sets, options, device, progress);
  Report report = make_report(model, outcome);
  report.command_line = options.settings(model, outcome);
  WriteOptions writing;
  writing.formats = options.format_list();
  writing.fields = options.fields;
  writing.palette = options.palette_map();
  writing.installed = options.installed;
  writing.threads = options.model.threads;
  writing.progress = [&](const char*, double fraction) { progress.update(fraction); };
  writing.run_record = [&] { return progress.end(), run_json(record, progress.stages()); };
  progress.begin("write");
  const Result<std::vector<std::string>> files = write(report, options.out, writing);
  progress.end();
  if (!files) return print(files.error()), exit_bad_input;
  if (!options.quiet)
    print_summary(terminal_report(report, terminal_style()) + list_of_files(options.out, *files));
  return exit_code(outcome, options.fail_on_value());
}

static int run_check(const CheckOptions& options) {
  const unsigned cores = std::thread::hardware_concurrency();
  RunRecord record{std::time(nullptr),
                   options.model.threads > 0 ? options.model.threads : static_cast<int>(cores),
                   options.command()};
  const Device device = choose_device(options.device, options.model.threads);
  static_cast<void>(options.format_list());
  static_cast<void>(options.model.sag_length());
  static_cast<void>(options.model.facet_size_length());
  check_output_folder(options.out);
  std::optional<std::vector<RuleSet>> sets = read_all_rules(options);
  if (!sets) return exit_bad_input;
  Progress progress(progress_is_visible());
  const Result<Model> model = options.model.load_model(progress);
  if (!model) return exit_bad_input;
  return check_model(*model, *sets, options, device, record, progress);
}

Command check_command(CLI::App& app, const std::filesystem::path& installed) {
  const auto options = std::make_shared<CheckOptions>();
  options->installed = installed;
  CLI::App* const command =
      app.add_subcommand("check", "Check a model against rules and write the evidence.");
  options->add_to(*command);
  command->footer(
      "--fail-on undecided: 1 for undecided rules too. never: 0 for both. A rule that\n"
      "was not run ends with 3 either way. --rules and --only may be given again.");
  return {command, [options] { return run_check(*options); }};
}

}  // namespace gabarit
