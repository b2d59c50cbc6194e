#include "rules/region.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace gabarit {

namespace {

using Combine = Selected (*)(Selected, Selected);

void give_edges(Region& region) {
  if (!region.edges.empty()) return;
  region.edges.reserve(region.facets.size());
  for (const Selected s : region.facets) region.edges.push_back({s, s, s});
}

void add_unless_there(std::vector<std::string>& notes, const std::vector<std::string>& more) {
  for (const std::string& note : more) {
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  }
}

void combine_edges(Region& a, Region& b, Combine combine) {
  if (a.edges.empty() && b.edges.empty()) return;
  give_edges(a);
  give_edges(b);
  for (std::size_t f = 0; f < a.edges.size(); ++f) {
    for (std::size_t e = 0; e < 3; ++e) a.edges[f][e] = combine(a.edges[f][e], b.edges[f][e]);
  }
}

void combine_depth(Region& a, const Region& b, bool larger) {
  if (a.depth.empty()) {
    a.depth = b.depth;
  } else if (!b.depth.empty()) {
    for (std::size_t f = 0; f < a.depth.size(); ++f) {
      a.depth[f] = larger ? std::max(a.depth[f], b.depth[f]) : std::min(a.depth[f], b.depth[f]);
    }
  }
}

void combine(Region& a, Region b, bool all) {
  const Combine logic = all ? both : either;
  combine_edges(a, b, logic);
  for (std::size_t f = 0; f < a.facets.size(); ++f) a.facets[f] = logic(a.facets[f], b.facets[f]);
  combine_depth(a, b, all);
  std::move(b.traces.begin(), b.traces.end(), std::back_inserter(a.traces));
  add_unless_there(a.notes, b.notes);
}

Region inverted(Region region) {
  for (Selected& s : region.facets) s = opposite(s);
  for (auto& edges : region.edges) {
    for (Selected& s : edges) s = opposite(s);
  }
  region.depth.clear();
  return region;
}

Interval band_left_by(const std::vector<Where>& children, Interval band) {
  for (const Where& child : children) {
    if (child.kind != Where::Kind::selector || !child.selector->height_band) continue;
    band = intersection(band, child.selector->height_band(child.arguments));
  }
  return band;
}

// A region that does not speak of every facet would leave some unexamined without a word.
Region checked(Region region, const Scene& scene, const Selector& selector) {
  const std::size_t n = scene.mesh().facet_count();
  if (region.facets.size() != n || (!region.edges.empty() && region.edges.size() != n) ||
      (!region.depth.empty() && region.depth.size() != n)) {
    throw std::logic_error(fmt::format("the selector `{}` did not answer for every facet", selector.name));
  }
  return region;
}

std::string joined_sentences(const std::vector<Where>& children, const char* word) {
  std::string text;
  for (const Where& child : children) {
    const bool nested = child.kind != Where::Kind::selector && child.children.size() > 1;
    text += fmt::format("{}{}{}{}", text.empty() ? "" : word, nested ? "(" : "", describe(child),
                        nested ? ")" : "");
  }
  return text;
}

}  // namespace

Region select(const Scene& scene, const Setup& setup, const Where& where) {
  if (where.kind == Where::Kind::selector) {
    return checked(where.selector->select(scene, setup, where.arguments), scene, *where.selector);
  }
  Setup inner = setup;
  if (where.kind == Where::Kind::all) inner.height_band = band_left_by(where.children, setup.height_band);
  if (where.kind == Where::Kind::none_of) inner.height_band = Interval{};
  if (where.children.empty()) return whole_model(scene.mesh());
  Region region = select(scene, inner, where.children.front());
  if (where.kind == Where::Kind::none_of) return inverted(std::move(region));
  for (std::size_t i = 1; i < where.children.size(); ++i) {
    combine(region, select(scene, inner, where.children[i]), where.kind == Where::Kind::all);
  }
  return region;
}

std::string describe(const Where& where) {
  switch (where.kind) {
    case Where::Kind::selector:
      return where.selector->sentence ? where.selector->sentence(where.arguments)
                                      : fmt::format("`{}` selects it", where.selector->name);
    case Where::Kind::none_of: return "not (" + describe(where.children.front()) + ")";
    case Where::Kind::any: return joined_sentences(where.children, " or ");
    case Where::Kind::all: break;
  }
  return where.children.empty() ? "the model has any" : joined_sentences(where.children, " and ");
}

bool same(const Where& a, const Where& b) {
  return a.kind == b.kind && a.selector == b.selector && a.arguments.all() == b.arguments.all() &&
         std::equal(a.children.begin(), a.children.end(), b.children.begin(), b.children.end(), same);
}

}  // namespace gabarit
