#include "examples/motorcycle/parts_file.h"

#include <nlohmann/json.hpp>

#include "report/output_file.h"

namespace gabarit::motorcycle {

void write_parts(const Parts& parts, const Tessellation& tessellation, const std::filesystem::path& file) {
  nlohmann::ordered_json root;
  root["sag"] = tessellation.sag;
  root["step"] = tessellation.step;
  root["parts"] = nlohmann::ordered_json::array();
  for (const Part& part : parts) {
    root["parts"].push_back({{"name", part.name},
                             {"expectation", name(part.expectation)},
                             {"true_radius", part.true_radius},
                             {"where", part.where},
                             {"first_facet", part.first},
                             {"facets", part.last - part.first}});
  }
  const std::string text = root.dump(2) + "\n";
  OutputFile output(file);
  output.write(text.data(), text.size());
  output.commit();
}

}  // namespace gabarit::motorcycle
