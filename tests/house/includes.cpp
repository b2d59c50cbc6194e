#include "tests/house/includes.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>

namespace gabarit::house {

namespace fs = std::filesystem;

static constexpr std::array layers{"gpu", "model", "checks", "rules", "report", "cli"};

static int layer_of(const std::string& path) {
  const std::string folder = path.substr(0, path.find('/'));
  const auto* const place = std::find(layers.begin(), layers.end(), folder);
  return place == layers.end() ? -1 : static_cast<int>(place - layers.begin());
}

static bool is_source(const fs::path& file) {
  static constexpr std::array endings{".h", ".cpp", ".cu", ".cuh"};
  return std::find(endings.begin(), endings.end(), file.extension().string()) != endings.end();
}

static void add_includes(const fs::path& tree, const fs::path& file, std::vector<Include>& out) {
  static const std::regex pattern(R"(^\s*#\s*include\s*(["<])([^">]+)[">])");
  std::ifstream text(file);
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    std::smatch match;
    if (std::regex_search(line, match, pattern)) {
      out.push_back({fs::relative(file, tree), number, match[2].str(), match[1].str() == "\""});
    }
  }
}

std::vector<Include> includes(const fs::path& tree, const std::vector<std::string>& folders) {
  std::vector<Include> out;
  for (const std::string& folder : folders) {
    if (!fs::exists(tree / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(tree / folder)) {
      if (entry.is_regular_file() && is_source(entry.path())) add_includes(tree, entry.path(), out);
    }
  }
  return out;
}

std::vector<std::string> layering_errors(const fs::path& tree) {
  std::vector<std::string> errors;
  for (const Include& include : includes(tree, {layers.begin(), layers.end()})) {
    const std::string file = include.file.generic_string();
    // gpu/ keeps its own tests and benchmarks, which are tests and benchmarks like any others.
    if (file.starts_with("gpu/tests/") || file.starts_with("gpu/bench/")) continue;
    const int to = layer_of(include.target);
    const bool outside = include.target.starts_with("tests/") || include.target.starts_with("bench/") ||
                         include.target.starts_with("examples/") ||
                         include.target.find("..") != std::string::npos;
    if ((to >= 0 && to > layer_of(file)) || outside) {
      errors.push_back(file + ":" + std::to_string(include.line) + ": may not include " + include.target);
    }
  }
  return errors;
}

}  // namespace gabarit::house
