#include "report/write_stl.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace gabarit {

// Little-endian on every machine.
static void put_word(unsigned char* to, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) to[i] = static_cast<unsigned char>(word >> (8 * i));
}

static void put_point(unsigned char* to, const Vec3d& p) {
  for (int axis = 0; axis < 3; ++axis, to += 4) {
    const auto coordinate = static_cast<float>(p[axis]);
    std::uint32_t word = 0;
    std::memcpy(&word, &coordinate, sizeof word);
    put_word(to, word);
  }
}

void write_stl(const TriangleMesh& mesh, const std::vector<FacetId>& facets, const std::string& title,
               OutputFile& file) {
  if (facets.size() > std::numeric_limits<std::uint32_t>::max())
    throw std::length_error("too many facets for STL");
  // Readers take a header that starts with "solid" for the text format; ours always starts with "Gabarit".
  std::array<unsigned char, 84> header{};
  std::memcpy(header.data(), title.data(), std::min<std::size_t>(title.size(), 80));
  put_word(header.data() + 80, static_cast<std::uint32_t>(facets.size()));
  file.write(header.data(), header.size());
  for (const FacetId f : facets) {
    std::array<unsigned char, 50> record{};
    unsigned char* to = record.data();
    put_point(to, facet_normal(mesh, f));
    for (int corner = 0; corner < 3; ++corner) put_point(to += 12, mesh.corner(f, corner));
    file.write(record.data(), record.size());
  }
}

std::vector<FacetId> failing_facets(const RuleResult& result) {
  std::vector<FacetId> facets;
  for (std::size_t i = 0; i < result.facet_verdicts.size(); ++i) {
    if (result.facet_verdicts[i] == FacetVerdict::fail) facets.push_back(result.field.facets[i]);
  }
  return facets;
}

std::vector<FacetId> failing_facets(const Outcome& outcome) {
  std::vector<FacetId> facets;
  for (const RuleResult& result : outcome.results) {
    const std::vector<FacetId> more = failing_facets(result);
    facets.insert(facets.end(), more.begin(), more.end());
  }
  std::sort(facets.begin(), facets.end());
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  return facets;
}

}  // namespace gabarit
