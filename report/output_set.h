// The files of one run, which replace those of an earlier run together.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "report/output_file.h"

namespace gabarit {

// Files are written whole into a hidden folder inside the output folder; commit() removes what an earlier run
// left and moves the new files into place. Destroyed without commit, or killed before it, the output folder
// holds what it held before (a killed run leaves its hidden folder, which the next run clears).
class OutputSet {
 public:
  // Creates the folder when it is missing. Throws filesystem_error when it can't be written, or when another
  // run is writing there.
  explicit OutputSet(std::filesystem::path folder);
  OutputSet(const OutputSet&) = delete;
  OutputSet& operator=(const OutputSet&) = delete;
  ~OutputSet();

  // `name` is relative to the folder, with '/' between its parts.
  void add(const std::string& name, const std::function<void(OutputFile&)>& write);
  // The names in the order they were added.
  std::vector<std::string> commit();

 private:
  void create_folder();
  void lock();
  void check_places() const;
  void create_parents() const;
  void move_into_place();

  std::filesystem::path folder_, staging_;
  std::vector<std::filesystem::path> created_;  // folders that were not there before, outermost first
  std::vector<std::string> names_;
  int lock_ = -1;
  bool committed_ = false;
};

}  // namespace gabarit
