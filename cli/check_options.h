// What `gabarit check` is asked to do.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/exit_code.h"
#include "cli/model_options.h"
#include "report/write.h"

namespace gabarit {

struct CheckOptions {
  ModelOptions model;
  std::vector<std::string> rules, only;
  std::string out, device = "auto", formats = "pdf,stl,json", fail_on = "fail", palette = "by-limit";
  bool fields = false, quiet = false;
  std::filesystem::path installed;  // what came with the program; may be empty

  void add_to(CLI::App& command);
  // Both throw UsageError.
  std::vector<Format> format_list() const;
  FailOn fail_on_value() const;
  ColourMap palette_map() const;
  // The command as given, for run.json.
  std::vector<std::string> command() const;
  // Those that change what is in the outputs, as they would be written again, without paths.
  std::vector<std::string> settings(const Model& model, const Outcome& outcome) const;
};

}  // namespace gabarit
