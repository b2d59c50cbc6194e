#include "examples/motorcycle/motorcycle.h"

#include <array>
#include <limits>
#include <stdexcept>

#include "examples/motorcycle/groups.h"
#include "model/weld.h"

namespace gabarit::motorcycle {

Parts parts() {
  Parts all;
  for (const auto add : {add_wheels, add_front_end, add_handlebar, add_mirrors, add_bodywork, add_panels,
                         add_engine, add_chassis, add_footrests, add_rear}) {
    add(all);
  }
  return all;
}

std::vector<Grid> grids(Parts& parts, const Tessellation& tessellation) {
  std::vector<Grid> all;
  std::size_t facets = 0;
  for (Part& part : parts) {
    part.first = static_cast<FacetId>(facets);
    for (const Surface& surface : part.surfaces) {
      all.push_back(grid(surface, tessellation));
      facets += all.back().facet_count(surface.ring);
      if (facets > std::numeric_limits<FacetId>::max())
        throw std::length_error("too many facets: take a larger step");
    }
    part.last = static_cast<FacetId>(facets);
  }
  return all;
}

static Vec3f single_precision(const Vec3d& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

void tessellate(const Parts& parts, const std::vector<Grid>& grids,
                const std::function<void(const SingleFacet&)>& sink) {
  const FacetSink rounded = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    sink({single_precision(a), single_precision(b), single_precision(c)});
  };
  auto grid = grids.begin();
  for (const Part& part : parts) {
    for (const Surface& surface : part.surfaces) tessellate(surface, *grid++, rounded);
  }
}

TriangleMesh mesh(const Parts& parts, const std::vector<Grid>& grids) {
  TriangleMesh all;
  const std::size_t count = parts.empty() ? 0 : parts.back().last;
  VertexWeld weld(all.vertices, count / 2);
  all.facets.reserve(count);
  tessellate(parts, grids, [&](const SingleFacet& facet) {
    std::array<Vec3d, 3> points;
    for (std::size_t i = 0; i < 3; ++i) points[i] = {facet[i].x, facet[i].y, facet[i].z};
    weld.add(points, all.facets.emplace_back().data());
  });
  for (std::uint32_t body = 0; body < parts.size(); ++body)
    all.body.insert(all.body.end(), parts[body].last - parts[body].first, body);
  return all;
}

}  // namespace gabarit::motorcycle
