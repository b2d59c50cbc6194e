// Reads the #include lines of a source tree and says which of them run against the layering.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gabarit::house {

struct Include {
  std::filesystem::path file;  // relative to the tree
  int line = 0;                // from 1
  std::string target;          // between the quotes or angle brackets
  bool quoted = false;
};

// Of every C++, CUDA and header file below the given folders of `tree`.
std::vector<Include> includes(const std::filesystem::path& tree, const std::vector<std::string>& folders);

// cli -> report -> rules -> checks -> model -> gpu: a folder may reach itself and any further right, nothing
// else of the project. One "file:line: message" for each include that does not.
std::vector<std::string> layering_errors(const std::filesystem::path& tree);

}  // namespace gabarit::house
