#include <memory>

#include <fmt/format.h>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/messages.h"
#include "cli/rule_file.h"

namespace gabarit {

static int run_validate(const std::vector<std::string>& files, const std::filesystem::path& installed) {
  int code = exit_clean;
  for (const std::string& file : files) {
    const Result<RuleSet> rules = read_named_rules(file, installed);
    if (rules) {
      print_result(fmt::format("{}: fine: {}, {} rules\n", file, rules->id, rules->rules.size()));
    } else {
      print(rules.error());
      code = exit_bad_input;
    }
  }
  return code;
}

Command validate_command(CLI::App& app, const std::filesystem::path& installed) {
  const auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* const command = app.add_subcommand("validate", "Report every error in rule files.");
  command->add_option("RULES", *files, "Rule files")->required()->type_name("");
  return {command, [files, installed] { return run_validate(*files, installed); }};
}

}  // namespace gabarit
