// The program that writes the example motorcycle: generate_motorcycle --out FILE.stl
#include <cmath>
#include <cstdio>
#include <exception>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "examples/motorcycle/motorcycle.h"
#include "examples/motorcycle/parts_file.h"
#include "examples/motorcycle/stl_stream.h"

namespace gabarit::motorcycle {

struct Options {
  std::string out, parts;
  Tessellation tessellation;
};

static void generate(const Options& options) {
  // A range lets NaN pass.
  if (std::isnan(options.tessellation.step) || std::isnan(options.tessellation.sag))
    throw std::invalid_argument("the step and the sag must be numbers");
  Parts all = parts();
  const std::vector<Grid> lines = grids(all, options.tessellation);
  OutputFile file(options.out);
  write_stl_header(file, all.back().last);
  tessellate(all, lines, [&](const SingleFacet& facet) { write_stl_facet(file, facet); });
  if (!options.parts.empty()) write_parts(all, options.tessellation, options.parts);
  file.commit();
  fmt::print("{}: {} facets, {} parts\n", options.out, all.back().last, all.size());
}

static int run(int argc, char** argv) {
  CLI::App app{"Writes the example motorcycle as a binary STL in millimetres."};
  Options options;
  app.add_option("--out", options.out, "The STL to write")->type_name("FILE.stl")->required();
  app.add_option("--step", options.tessellation.step, "Longest edge across a rounding, mm")
      ->type_name("MM")
      ->check(CLI::Range(0.05, 100.0))
      ->capture_default_str();
  app.add_option("--sag", options.tessellation.sag, "Largest distance between surface and facets, mm")
      ->type_name("MM")
      ->check(CLI::Range(0.0005, 10.0))
      ->capture_default_str();
  app.add_option("--parts", options.parts, "Also write the list of parts and what the check must find")
      ->type_name("FILE.json");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "error: %s\nSee generate_motorcycle --help.\n", error.what());
    return 2;
  }
  generate(options);
  return 0;
}

}  // namespace gabarit::motorcycle

int main(int argc, char** argv) {
  try {
    return gabarit::motorcycle::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 2;
  }
}
