#include "checks/body.h"

#include <algorithm>

#include <fmt/format.h>

namespace gabarit {

namespace {

std::size_t character_length(std::string_view text) {
  std::size_t n = 1;
  while (n < text.size() && (static_cast<unsigned char>(text[n]) & 0xC0U) == 0x80U) ++n;
  return n;
}

std::string note_without_match(const std::string& pattern, const std::vector<std::string>& bodies) {
  constexpr std::size_t most = 10;
  std::string names;
  for (std::size_t i = 0; i < std::min(most, bodies.size()); ++i) {
    names += fmt::format("{}`{}`", i == 0 ? "" : ", ", bodies[i]);
  }
  if (bodies.size() > most) names += fmt::format(", … ({} in all)", bodies.size());
  return fmt::format("No body is named `{}`; the model has {}.", pattern, names.empty() ? "no names" : names);
}

Region select_body(const Scene& scene, const Setup&, const Arguments& arguments) {
  const TriangleMesh& mesh = scene.mesh();
  const std::vector<std::string>& bodies = scene.model().bodies;
  const std::string& pattern = arguments.text("name");
  std::vector<Selected> chosen(bodies.size(), Selected::no);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (matches(pattern, bodies[i])) chosen[i] = Selected::yes;
  }
  Region region;
  region.facets.reserve(mesh.facet_count());
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const std::uint32_t body = mesh.body_of(f);
    region.facets.push_back(body < chosen.size() ? chosen[body] : Selected::no);
  }
  if (std::count(chosen.begin(), chosen.end(), Selected::yes) == 0) {
    region.notes.push_back(note_without_match(pattern, bodies));
  }
  return region;
}

std::string sentence(const Arguments& arguments) {
  return fmt::format("it belongs to a body named `{}`", arguments.text("name"));
}

}  // namespace

// Greedy with one point to come back to: linear in practice, never exponential.
bool matches(std::string_view pattern, std::string_view name) {
  std::size_t p = 0, n = 0, star = std::string_view::npos, resume = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = n;
    } else if (p < pattern.size() && pattern[p] == '?') {
      ++p;
      n += character_length(name.substr(n));
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p;
      ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      resume += character_length(name.substr(resume));
      n = resume;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

const Selector body_selector{.name = "body",
                             .summary = "Facets of the bodies whose name fits a pattern.",
                             .documentation =
                                 "The whole name must fit; `*` stands for any characters, `?` for one. The "
                                 "case of letters counts. A pattern "
                                 "that begins with `*` is written in quotes.\n\n"
                                 "A pattern that no body fits selects nothing and is noted in the report, "
                                 "with the names that there are.",
                             .parameters = {{.name = "name",
                                             .dimension = Dimension::text,
                                             .documentation = "The name, or a pattern such as \"tank*\"."}},
                             .select = select_body,
                             .sentence = sentence};

}  // namespace gabarit
