#include "bench/thickness_chart.h"

#include <cmath>

#include <fmt/format.h>

namespace gabarit {
namespace {

constexpr double left = 90, right = 560, top = 30, bottom = 390;
constexpr double first_facets = 4, last_facets = 6.5, first_seconds = -3, last_seconds = 5;  // powers of ten

double x_of(double facets) {
  return left + (std::log10(facets) - first_facets) / (last_facets - first_facets) * (right - left);
}
double y_of(double seconds) {
  return bottom - (std::log10(seconds) - first_seconds) / (last_seconds - first_seconds) * (bottom - top);
}

std::string text(double x, double y, const char* anchor, const std::string& words, const char* colour) {
  return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n", x, y,
                     anchor, colour, words);
}

std::string grid() {
  std::string svg;
  for (const auto& [facets, name] : {std::pair{1e4, "10 k"}, {1e5, "100 k"}, {1e6, "1 M"}}) {
    svg += fmt::format("<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#ddd\"/>\n", x_of(facets), top, bottom);
    svg += text(x_of(facets), bottom + 20, "middle", name, "#444");
  }
  for (int power = static_cast<int>(first_seconds); power <= last_seconds; ++power) {
    const double y = y_of(std::pow(10, power));
    svg += fmt::format("<path d=\"M{0} {1:.1f}H{2}\" stroke=\"#ddd\"/>\n", left, y, right);
    svg += text(left - 8, y + 4, "end", fmt::format("{:g} s", std::pow(10, power)), "#444");
  }
  return svg + text((left + right) / 2, bottom + 42, "middle", "facets", "#444");
}

std::string drawn(const ChartLine& line) {
  std::string path, marks;
  for (const auto& [facets, seconds] : line.points) {
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x_of(facets), y_of(seconds));
    marks += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", x_of(facets),
                         y_of(seconds), line.colour);
  }
  return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}/>\n", path, line.colour,
                     line.dashed ? " stroke-dasharray=\"6 4\"" : "") +
         marks +
         text(x_of(line.points.back().first) + 10, y_of(line.points.back().second) + 4, "start", line.name,
              line.colour.c_str());
}

}  // namespace

std::string thickness_chart(const std::vector<ChartLine>& lines) {
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 760 450\" font-family=\"sans-serif\" "
      "font-size=\"13\">\n<rect width=\"760\" height=\"450\" fill=\"white\"/>\n" +
      grid();
  for (const ChartLine& line : lines) svg += drawn(line);
  return svg + "</svg>\n";
}

}  // namespace gabarit
