#include "rules/findings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "checks/disjoint_sets.h"
#include "model/adjacency.h"
#include "rules/worst.h"

namespace gabarit {

namespace {

using Entries = std::vector<std::size_t>;  // into a field, ascending

// Groups the entries by connection; groups are in the order of their first facet.
std::vector<Entries> connected(const TriangleMesh& mesh, const Field& field, const Entries& entries) {
  std::vector<FacetId> facets;
  facets.reserve(entries.size());
  for (const std::size_t entry : entries) facets.push_back(field.facets[entry]);
  const Adjacency adjacency(mesh, facets);
  DisjointSets patches(entries.size());  // the root of a patch is its lowest facet
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (const EdgeNeighbour& neighbour : adjacency.of(facets[i])) {
      const auto there = std::lower_bound(facets.begin(), facets.end(), neighbour.facet);
      if (there == facets.end() || *there != neighbour.facet) continue;
      patches.join(i, static_cast<std::size_t>(there - facets.begin()));
    }
  }
  std::vector<std::size_t> group(entries.size());
  std::vector<Entries> groups;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::size_t r = patches.root(i);
    if (r == i) {
      group[i] = groups.size();
      groups.emplace_back();
    }
    groups[group[r]].push_back(entries[i]);
  }
  return groups;
}

// Non-finite facets have no area and no place: a patch of nothing else has a centroid of NaN.
void measure_extent(Finding& finding, const TriangleMesh& mesh) {
  Vec3d moment;
  for (const FacetId f : finding.facets) {
    const double area = facet_area(mesh, f);
    if (area > 0) moment += mesh.centroid(f) * area;
    finding.area += area;
    for (const Vec3d& corner : mesh.corners(f)) {
      if (is_finite(corner)) finding.box.add(corner);
    }
  }
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  finding.centroid = finding.area > 0      ? moment / finding.area
                     : finding.box.empty() ? Vec3d{unknown, unknown, unknown}
                                           : finding.box.centre();
}

std::vector<FaceId> faces_of(const Brep& brep, const std::vector<FacetId>& facets) {
  std::vector<FaceId> faces;
  faces.reserve(facets.size());
  for (const FacetId f : facets) faces.push_back(brep.facets.at(f).face);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

struct Ranked {
  Finding finding;
  double excess = 0;
};

bool graver(const Ranked& a, const Ranked& b) {
  if (a.excess != b.excess) return a.excess > b.excess;
  if (a.finding.area != b.finding.area) return a.finding.area > b.finding.area;
  return a.finding.facets.front() < b.finding.facets.front();
}

Ranked describe(const Model& model, const Rule& rule, const Field& field,
                const std::vector<FacetVerdict>& verdicts, const Entries& entries) {
  Ranked result;
  Finding& finding = result.finding;
  const std::size_t worst = worst_entry(field, verdicts, rule.require.limit, entries);
  finding.verdict = verdicts[worst] == FacetVerdict::fail ? Verdict::fail : Verdict::undecided;
  for (const std::size_t entry : entries) finding.facets.push_back(field.facets[entry]);
  finding.worst = worst_at(field, worst);
  measure_extent(finding, model.mesh);
  if (model.bodies.size() > 1 || model.brep)
    finding.body = model.bodies.at(model.mesh.body_of(finding.worst.facet));
  if (model.brep) finding.faces = faces_of(*model.brep, finding.facets);
  const double e = excess(field, worst, rule.require.limit);
  result.excess = std::isnan(e) ? -std::numeric_limits<double>::infinity() : e;  // keeps the order total
  return result;
}

void add_patches(Findings& findings, const Model& model, const Rule& rule, const Field& field,
                 const std::vector<FacetVerdict>& verdicts, FacetVerdict wanted) {
  Entries entries;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (verdicts[i] == wanted) entries.push_back(i);
  }
  if (entries.empty()) return;
  std::vector<Ranked> patches;
  for (const Entries& group : connected(model.mesh, field, entries)) {
    Ranked patch = describe(model, rule, field, verdicts, group);
    if (patch.finding.area < rule.ignore_area) {
      ++findings.ignored;
    } else {
      patches.push_back(std::move(patch));
    }
  }
  std::sort(patches.begin(), patches.end(), graver);
  for (Ranked& patch : patches) findings.listed.push_back(std::move(patch.finding));
}

}  // namespace

Findings find_patches(const Model& model, const Rule& rule, const Field& field,
                      const std::vector<FacetVerdict>& verdicts) {
  Findings findings;
  add_patches(findings, model, rule, field, verdicts, FacetVerdict::fail);
  add_patches(findings, model, rule, field, verdicts, FacetVerdict::undecided);
  for (std::size_t i = 0; i < findings.listed.size(); ++i) {
    findings.listed[i].id = fmt::format("{}/{}", rule.id, i + 1);
  }
  return findings;
}

}  // namespace gabarit
