// Options that say how a model file is to be understood, shared by the commands that load one.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "cli/progress.h"
#include "model/load.h"

namespace gabarit {

struct ModelOptions {
  std::string file, units, sag, facet_size;
  int threads = 0;

  void add_file_to(CLI::App& command);
  void add_options_to(CLI::App& command);
  // In millimetres. Throw UsageError when it is no positive length.
  std::optional<double> sag_length() const;
  std::optional<double> facet_size_length() const;
  // Prints what is wrong, or what is to be warned about, on standard error.
  Result<Model> load_model(Progress& progress) const;
};

}  // namespace gabarit
