// The paper's Fig. 12 as an SVG: seconds for all facets against their number, both axes logarithmic.
#pragma once

#include <string>
#include <vector>

namespace gabarit {

struct ChartLine {
  std::string name, colour;
  bool dashed = false;
  std::vector<std::pair<double, double>> points;  // facets, seconds
};

std::string thickness_chart(const std::vector<ChartLine>& lines);

}  // namespace gabarit
