#include "cli/model_options.h"

#include <cmath>
#include <csignal>

#include <unistd.h>

#include "cli/exit_code.h"
#include "cli/messages.h"
#include "rules/quantity.h"

namespace gabarit {

void ModelOptions::add_file_to(CLI::App& command) {
  command.add_option("MODEL", file, "STL, OBJ, PLY, OFF, STEP or IGES file")->required()->type_name("");
}

void ModelOptions::add_options_to(CLI::App& command) {
  command.add_option("--units", units, "Of the file: mm, cm, m or in [mm]")
      ->check(CLI::IsMember({"mm", "cm", "m", "in"}).description(""))
      ->type_name("UNIT");
  command.add_option("--sag", sag, "Chord height of the facets, e.g. \"0.05 mm\"")->type_name("LENGTH");
  command.add_option("--facet-size", facet_size, "Longest side of facets made of STEP and IGES")
      ->type_name("LENGTH");
  command.add_option("--threads", threads, "CPU threads [all cores]")
      ->check(CLI::Range(1, 4096).description(""))
      ->type_name("N");
}

static std::optional<double> positive_length(const std::string& option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  const Result<double, Complaint> length = read_quantity(text, Dimension::length);
  if (!length) throw UsageError{option + ": " + length.error().message + ". " + length.error().hint};
  if (!(*length > 0) || !std::isfinite(*length))
    throw UsageError{option + " must be more than 0, not " + text};
  return *length;
}

std::optional<double> ModelOptions::sag_length() const { return positive_length("--sag", sag); }
std::optional<double> ModelOptions::facet_size_length() const {
  return positive_length("--facet-size", facet_size);
}

// What the system sends when a mapped file shrinks while it is read. Nothing has been written so far.
extern "C" {
static void stop_reading(int) {
  static constexpr char text[] = "gabarit: error: the model file changed while it was read; run again\n";
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text, sizeof text - 1);
  ::_exit(exit_bad_input);
}
}

Result<Model> ModelOptions::load_model(Progress& progress) const {
  LoadOptions options;
  if (!units.empty()) options.unit = unit_named(units);
  options.sag = sag_length();
  options.facet_size = facet_size_length();
  options.threads = threads;
  options.progress = [&](const char*, double fraction) { progress.update(fraction); };
  progress.begin("load");
  auto* const before = std::signal(SIGBUS, stop_reading);
  Result<Model> model = load(file, options);
  std::signal(SIGBUS, before);
  progress.end();
  print(model ? model->warnings : model.error());
  return model;
}

}  // namespace gabarit
