#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>

#include "cli/command.h"
#include "cli/devices.h"
#include "cli/exit_code.h"
#include "cli/messages.h"
#include "cli/model_options.h"
#include "cli/on_device.h"
#include "cli/output_folder.h"
#include "report/display_unit.h"
#include "report/number_text.h"
#include "report/version.h"
#include "report/write_ply.h"
#include "rules/catalogue.h"
#include "rules/nearest_name.h"
#include "rules/read_value.h"
#include "rules/setup.h"

namespace gabarit {

namespace {

struct MeasureOptions {
  ModelOptions model;
  std::string measure, out;
};

// Over the facets that have a value.
struct Summary {
  double least = std::numeric_limits<double>::infinity(), greatest = -least, area = 0, weighted = 0;
  std::size_t facets = 0;
};

}  // namespace

// As written on the command line: "--separation-angle" for a parameter "separation angle".
static std::string option_name(const Parameter& parameter) {
  std::string name = "--" + parameter.name;
  for (char& c : name) c = c == ' ' || c == '_' ? '-' : c;
  return name;
}

static const Measure& known_measure(const std::string& name) {
  const Catalogue catalogue;
  if (const Measure* const measure = catalogue.measure_named(name)) return *measure;
  throw UsageError{
      fmt::format("no measure is called `{}`: {}", name, name_hint(name, catalogue.measure_names()))};
}

static const Parameter& known_parameter(const Measure& measure, const std::string& option) {
  std::vector<std::string> names;
  for (const Parameter& parameter : measure.parameters) {
    if (option_name(parameter) == option) return parameter;
    names.push_back(option_name(parameter));
  }
  throw UsageError{
      fmt::format("`{}` has no option `{}`: {}", measure.name, option, name_hint(option, names))};
}

// What the option parser left: "--name value" or "--name=value".
static Arguments read_parameters(const Measure& measure, const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t equals = words[i].find('=');
    const std::string option = words[i].substr(0, equals);
    const Parameter& parameter = known_parameter(measure, option);
    if (equals == std::string::npos && ++i == words.size()) throw UsageError{option + " needs a value"};
    const std::string text = equals == std::string::npos ? words[i] : words[i].substr(equals + 1);
    const Result<Value, Complaint> value = read_value(parameter, text);
    if (!value)
      throw UsageError{fmt::format("{}: {}. {}", option, value.error().message, value.error().hint)};
    arguments.set(parameter.name, *value);
  }
  const std::vector<std::string> missing = fill_defaults(measure.parameters, arguments);
  if (!missing.empty())
    throw UsageError{fmt::format("`{}` needs a value for `{}`", measure.name, missing.front())};
  return arguments;
}

static Summary summarise(const TriangleMesh& mesh, const Field& field) {
  Summary s;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const double value = field.value[i];
    if (std::isnan(value)) continue;
    const double area = facet_area(mesh, field.facets[i]);
    s.least = std::min(s.least, value);
    s.greatest = std::max(s.greatest, value);
    // A value without limit, such as the radius of a plane, would drown the mean of the others.
    if (std::isfinite(value)) s.area += area, s.weighted += area * value;
    ++s.facets;
  }
  return s;
}

static std::string summary_text(const Measure& measure, const Summary& s, const Model& model) {
  const DisplayUnit unit = display_unit(measure.dimension);
  const auto shown = [&](double value) {
    return fmt::format("{} {}", number_text(value * unit.factor), unit.name);
  };
  std::string text =
      fmt::format("{}: {} of {} facets have a value\n", measure.name, s.facets, model.mesh.facet_count());
  if (s.facets == 0) return text;
  text += fmt::format("min   {}\nmax   {}\n", shown(s.least), shown(s.greatest));
  if (s.area > 0)
    text += fmt::format("mean  {} (weighted by area, over finite values)\n", shown(s.weighted / s.area));
  return text;
}

static Diagnostics write_field(const std::string& out, const FieldView& view) {
  try {
    OutputFile file(out);
    write_ply(view, file);
    file.commit();
    return {};
  } catch (const std::filesystem::filesystem_error& error) {
    return {{.file = out, .message = "cannot write: " + error.code().message()}};
  }
}

static int run_measure(const MeasureOptions& options, const std::vector<std::string>& parameters) {
  const Measure& measure = known_measure(options.measure);
  const Arguments arguments = read_parameters(measure, parameters);
  check_output_file(options.out);
  Progress progress(progress_is_visible());
  const Result<Model> model = options.model.load_model(progress);
  if (!model) return exit_bad_input;
  progress.begin(measure.name);
  Setup setup = resolve_setup(*model, RuleSet{}, options.model.sag_length());
  setup.progress = [&](double fraction) { progress.update(fraction); };
  const Region region = whole_model(model->mesh);
  const Field field = on_device(
      choose_device("auto", options.model.threads), false,
      [&](const Device& device) { return measure.measure(Scene(*model, device), setup, region, arguments); },
      [](const std::string& trouble) { print_error(trouble + "; the CPU computes all of it instead"); });
  progress.begin("write");
  const Diagnostics failed = write_field(
      options.out, {&model->mesh, &region, &field, nullptr, display_unit(measure.dimension).factor,
                    fmt::format("Gabarit {} {}", program_version, measure.name)});
  progress.end();
  print(failed);
  if (!failed.empty()) return exit_bad_input;
  std::string notes;
  for (const std::string& note : field.notes) notes += note + '\n';
  print_result(summary_text(measure, summarise(model->mesh, field), *model) + notes);
  return exit_clean;
}

Command measure_command(CLI::App& app) {
  const auto options = std::make_shared<MeasureOptions>();
  CLI::App* const command = app.add_subcommand("measure", "Measure the whole model, without rules.");
  options->model.add_file_to(*command);
  command->add_option("MEASURE", options->measure, "Such as radius; gabarit explain lists all")
      ->required()
      ->type_name("");
  command->add_option("--out", options->out, "Field to write, a PLY file")->required()->type_name("FILE");
  options->model.add_options_to(*command);
  command->allow_extras();
  command->footer(
      "A measure's own parameters are options too: --method turning.\n"
      "gabarit explain MEASURE lists them.");
  return {command, [options, command] { return run_measure(*options, command->remaining()); }};
}

}  // namespace gabarit
