#include "cli/brep_text.h"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "report/number_text.h"

namespace gabarit {
namespace {

// "12: 6 plane, 4 cylinder, 2 torus", kinds without any left out.
template <class Kind, std::size_t N>
std::string counted(const std::array<std::size_t, N>& counts) {
  std::string text;
  for (std::size_t k = 0; k < N; ++k) {
    if (counts[k] > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counts[k], name(static_cast<Kind>(k)));
  }
  return text;
}

std::string faces_text(const Brep& brep) {
  std::array<std::size_t, surface_kinds> counts{};
  for (const Face& face : brep.faces) ++counts[static_cast<std::size_t>(brep.surfaces[face.surface].kind)];
  return fmt::format("faces        {}: {}\n", brep.faces.size(), counted<SurfaceKind>(counts));
}

std::string named_text(const Brep& brep) {
  const auto named = std::count_if(brep.labels.begin(), brep.labels.end(),
                                   [](const FaceLabel& label) { return !label.name.empty(); });
  return named == 0 ? "" : fmt::format("face names   {} of {}\n", named, brep.faces.size());
}

// "#FF0000 on 3 faces, #AAAAAA on 1 face, none on 12", the most frequent first.
std::string colours_text(const Brep& brep) {
  constexpr std::size_t most = 8;
  std::map<std::uint32_t, std::size_t> counts;
  std::size_t without = 0;
  for (const FaceLabel& label : brep.labels) {
    if (const auto& c = label.colour)
      ++counts[static_cast<std::uint32_t>(c->red << 16 | c->green << 8 | c->blue)];
    else
      ++without;
  }
  if (counts.empty()) return "";
  std::vector<std::pair<std::uint32_t, std::size_t>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text = fmt::format("colours      {}: ", sorted.size());
  for (std::size_t i = 0; i < std::min(most, sorted.size()); ++i)
    text += fmt::format("{}#{:06X} on {} face{}", i == 0 ? "" : ", ", sorted[i].first, sorted[i].second,
                        sorted[i].second == 1 ? "" : "s");
  if (sorted.size() > most) text += ", …";
  if (without > 0) text += fmt::format(", none on {}", without);
  return text + '\n';
}

std::string edges_text(const Brep& brep) {
  std::array<std::size_t, edge_kinds> counts{};
  for (const Edge& edge : brep.edges) ++counts[static_cast<std::size_t>(edge.kind)];
  return fmt::format("edges        {}: {}\n", brep.edges.size(), counted<EdgeKind>(counts));
}

double greatest_tolerance(const Brep& brep) {
  double greatest = 0;
  for (const Face& face : brep.faces) greatest = std::max(greatest, face.tolerance);
  for (const Edge& edge : brep.edges) greatest = std::max(greatest, edge.tolerance);
  for (const BrepVertex& vertex : brep.vertices) greatest = std::max(greatest, vertex.tolerance);
  return greatest;
}

// Names that bodies share are listed once, with their number.
std::string names_text(const std::vector<std::string>& bodies) {
  constexpr std::size_t most = 20;
  std::vector<std::pair<std::string, std::size_t>> names;
  for (const std::string& body : bodies) {
    const auto known =
        std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == body; });
    if (known == names.end()) {
      names.emplace_back(body, 1);
    } else {
      ++known->second;
    }
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) {
    text += fmt::format("{}`{}`", i == 0 ? "" : ", ", names[i].first);
    if (names[i].second > 1) text += fmt::format(" × {}", names[i].second);
  }
  if (names.size() > most) text += fmt::format(", … ({} names in all)", names.size());
  return fmt::format("names        {}\n", text);
}

}  // namespace

std::string brep_text(const Model& model) {
  if (!model.brep) return "";
  const Brep& brep = *model.brep;
  return names_text(model.bodies) + faces_text(brep) + named_text(brep) + colours_text(brep) +
         edges_text(brep) +
         fmt::format("tolerance    {} mm at most\nvalid        {}\n", number_text(greatest_tolerance(brep)),
                     brep.invalid_bodies == 0 ? "yes"
                                              : fmt::format("no: {} of {} bodies needed repair",
                                                            brep.invalid_bodies, model.bodies.size()));
}

}  // namespace gabarit
