#include "rules/explain.h"

#include <memory>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/messages.h"
#include "rules/schema.h"

namespace gabarit {

namespace {

struct ExplainOptions {
  std::string name;
  bool schema = false;
};

}  // namespace

static int run_explain(const ExplainOptions& options) {
  if (options.schema || options.name.empty()) {
    print_result(options.schema ? rules_schema() : explain_all());
    return exit_clean;
  }
  const Result<std::string, Complaint> text = explain(options.name);
  if (!text)
    throw UsageError{text.error().message + (text.error().hint.empty() ? "" : "\n" + text.error().hint)};
  print_result(*text);
  return exit_clean;
}

Command explain_command(CLI::App& app) {
  const auto options = std::make_shared<ExplainOptions>();
  CLI::App* const command = app.add_subcommand("explain", "Say what a selector or a measure does.");
  command->add_option("NAME", options->name, "Such as contact or radius; none lists all")->type_name("");
  command->add_flag("--schema", options->schema, "Print the JSON Schema of rule files instead");
  return {command, [options] { return run_explain(*options); }};
}

}  // namespace gabarit
