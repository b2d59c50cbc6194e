// Writes the outputs of a run. Each file is written beside its place and renamed: a killed run leaves no half
// file. Outputs of an earlier run in the same folder are removed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "model/result.h"
#include "report/palette.h"
#include "report/report.h"

namespace gabarit {

enum class Format { pdf, stl, json, html, junit, sarif };

struct WriteOptions {
  std::vector<Format> formats{Format::pdf, Format::stl, Format::json};
  bool fields = false;
  ColourMap palette = ColourMap::by_limit;  // of the PDF's heat maps
  std::filesystem::path installed;  // what came with the program, see report/installation.h; may be empty
  int threads = 0;
  std::function<std::string()> run_record;  // the text of run.json, asked for last; empty: no such file
  std::function<void(const char* stage, double fraction)> progress;  // may be empty
};

// The files written, relative to `folder`; or why one could not be (full disk, no permission), with `folder`
// left as it was as far as the file system allows.
Result<std::vector<std::string>> write(const Report& report, const std::filesystem::path& folder,
                                       const WriteOptions& options);

}  // namespace gabarit
