#include "gpu/query_trials.h"

#include <array>
#include <bit>
#include <memory>
#include <utility>

#include "gpu/angle_batch.h"
#include "gpu/box.h"
#include "gpu/closest_point.h"
#include "gpu/dexel.h"
#include "gpu/distance_transform.h"
#include "gpu/maximal_sphere.h"
#include "gpu/outline_cells.h"
#include "gpu/plan_facets.h"
#include "gpu/plan_sides.h"
#include "gpu/ray_cast.h"
#include "gpu/rolling_depth.h"
#include "gpu/segment_grid.h"

namespace gabarit {
namespace {

// Padding would not compare.
class Bits {
 public:
  Bits& add(double x) { return words_.push_back(std::bit_cast<std::uint64_t>(x)), *this; }
  Bits& add(const Vec3d& p) { return add(p.x).add(p.y).add(p.z); }
  Bits& add(std::uint32_t n) { return words_.push_back(n), *this; }
  std::vector<std::uint64_t> take() && { return std::move(words_); }

 private:
  std::vector<std::uint64_t> words_;
};

void add(Bits& bits, const SphereContact& c) {
  bits.add(c.radius).add(c.lower).add(c.upper).add(c.contact).add(c.primitive);
}
void add(Bits& bits, const RayHit& hit) { bits.add(hit.distance).add(hit.facing).add(hit.facet); }
void add(Bits& bits, const ClosestPoint& c) { bits.add(c.distance).add(c.point).add(c.facet); }
void add(Bits& bits, const Dexel& d) { bits.add(d.from).add(d.to); }
void add(Bits& bits, const PlanSide& s) {
  bits.add(s.from.x).add(s.from.y).add(s.to.x).add(s.to.y).add(s.facet);
  bits.add(std::uint32_t{s.edge}).add(static_cast<std::uint32_t>(s.turn));
}
void add(Bits& bits, const AngleValues& v) {
  bits.add(v.sine).add(v.cosine).add(v.angle).add(v.arc_cosine);
  bits.add(v.hyperbolic_sine).add(v.hyperbolic_cosine);
}
void add(Bits& bits, float x) { bits.add(static_cast<double>(x)); }
void add(Bits& bits, std::uint8_t x) { bits.add(std::uint32_t{x}); }
void add(Bits& bits, std::uint32_t x) { bits.add(x); }

template <class T>
std::vector<std::uint64_t> bits_of(const std::vector<T>& all) {
  Bits bits;
  for (const T& x : all) add(bits, x);
  return std::move(bits).take();
}

struct Facet {
  Vec3d middle, inwards;
  std::uint32_t id;
};

// In the order of the tree, as checks ask: neighbours lie close together.
std::vector<Facet> facets_of(const FacetSurface& surface, const Bvh& tree) {
  std::vector<Facet> by_id(surface.primitives.size());
  for (const Primitive& p : surface.primitives) {
    const Vec3d sum = surface.points[p.corner[0]] + surface.points[p.corner[1]] + surface.points[p.corner[2]];
    const Vec3d n{static_cast<double>(p.normal.x), static_cast<double>(p.normal.y),
                  static_cast<double>(p.normal.z)};
    by_id[p.id] = {sum / 3.0, normalized(-n), p.id};
  }
  std::vector<Facet> facets;
  for (const std::uint32_t id : tree.order()) facets.push_back(by_id[id]);
  return facets;
}

// Queries made of the facets, asked of a tree that is built before.
template <class Query, class Answer, class Make, class Ask>
PreparedTrial asked_of_tree(const Device& device, const FacetSurface& surface, Make&& make, Ask&& ask) {
  struct State {
    Bvh tree;
    std::vector<Query> queries;
    std::vector<Answer> answers;
  };
  const auto state = std::make_shared<State>(State{Bvh(device, surface), {}, {}});
  for (const Facet& facet : facets_of(surface, state->tree)) state->queries.push_back(make(facet));
  state->answers.resize(state->queries.size());
  return {[state, ask] { ask(state->tree, state->queries, state->answers); },
          [state] { return bits_of(state->answers); }};
}

PreparedTrial spheres(const Device& device, const FacetSurface& surface) {
  return asked_of_tree<SphereQuery, SphereContact>(
      device, surface, [](const Facet& f) { return SphereQuery{f.middle, f.inwards, f.id, 0.01F, 0, 0}; },
      [](const Bvh& tree, const auto& queries, auto& answers) {
        maximal_spheres(tree, {.cos_separation = -0.5, .contact_floor = 1e-6}, queries, answers);
      });
}

PreparedTrial rays(const Device& device, const FacetSurface& surface) {
  return asked_of_tree<Ray, RayHit>(
      device, surface,
      [](const Facet& f) {
        return Ray{f.middle, f.inwards, f.id, 1e-6};
      },
      [](const Bvh& tree, const auto& queries, auto& answers) { cast_rays(tree, queries, answers); });
}

PreparedTrial nearest(const Device& device, const FacetSurface& surface) {
  return asked_of_tree<Vec3d, ClosestPoint>(
      device, surface, [](const Facet& f) { return f.middle + 0.37 * f.inwards; },
      [](const Bvh& tree, const auto& queries, auto& answers) { closest_points(tree, queries, answers); });
}

PreparedTrial tree(const Device& device, const FacetSurface& surface) {
  const auto order = std::make_shared<std::vector<std::uint32_t>>();
  return {[=, &surface] { *order = Bvh(device, surface).order(); }, [order] { return bits_of(*order); }};
}

std::vector<std::array<std::uint32_t, 3>> corners_of(const FacetSurface& surface) {
  std::vector<std::array<std::uint32_t, 3>> facets;
  for (const Primitive& p : surface.primitives) facets.push_back(p.corner);
  return facets;
}

// Room for the surface, on a million cells for large ones.
CellGrid grid_over(const FacetSurface& surface) {
  Box3d box;
  for (const Vec3d& p : surface.points) box.add(p);
  const double side = 1.1 * std::max(box.extent().x, box.extent().y) + 1e-9;
  const Vec3d middle = box.centre();
  const auto cells = static_cast<std::int64_t>(
      std::clamp(7 * std::sqrt(static_cast<double>(surface.primitives.size())), 64.0, 1000.0));
  return {
      {middle.x - side / 2, middle.y - side / 2}, side / static_cast<double>(cells), cells + 1, cells + 1};
}

// Between two heights, so that some facets are cut.
PlanFacets plan_of(const Device& device, const FacetSurface& surface,
                   const std::vector<std::array<std::uint32_t, 3>>& facets) {
  Box3d box;
  for (const Vec3d& p : surface.points) box.add(p);
  const double part = box.extent().z / 7;
  return {device, surface.points, facets, {}, box.min.z + part, box.max.z - part};
}

struct PlanState {
  CellGrid grid;
  std::vector<std::array<std::uint32_t, 3>> facets;
  PlanFacets plan;
  OutlineCells outlines;
  std::vector<std::uint8_t> cells;
  std::vector<float> distance;

  PlanState(const Device& device, const FacetSurface& surface)
      : grid(grid_over(surface)),
        facets(corners_of(surface)),
        plan(plan_of(device, surface, facets)),
        outlines(device, plan.mesh(), grid),
        cells(static_cast<std::size_t>(grid.count())),
        distance(cells.size()) {}
  void mark() {
    std::fill(cells.begin(), cells.end(), std::uint8_t{0});
    outlines.mark(cells);
  }
};

PreparedTrial projection(const Device& device, const FacetSurface& surface) {
  struct State {
    std::vector<std::array<std::uint32_t, 3>> facets;
    std::vector<PlanSide> sides;
  };
  const auto state = std::make_shared<State>(State{corners_of(surface), {}});
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t f = 0; f < state->facets.size(); f += 2) chosen.push_back(f);
  return {[=, &surface] {
            const PlanFacets plan = plan_of(device, surface, state->facets);
            state->sides = plan_sides(device, plan.mesh(), chosen);
          },
          [state] { return bits_of(state->sides); }};
}

PreparedTrial raster(const Device& device, const FacetSurface& surface) {
  const auto state = std::make_shared<PlanState>(device, surface);
  return {[=] { state->mark(); }, [state] { return bits_of(state->cells); }};
}

PreparedTrial distances(const Device& device, const FacetSurface& surface) {
  const auto state = std::make_shared<PlanState>(device.host(), surface);
  state->mark();
  return {[=] { distance_transform(device, state->grid, state->cells, state->distance); },
          [state] { return bits_of(state->distance); }};
}
PreparedTrial near_facets(const Device& device, const FacetSurface& surface) {
  const auto state = std::make_shared<PlanState>(device, surface);
  state->mark();
  distance_transform(device.host(), state->grid, state->cells, state->distance);
  for (float& d : state->distance) d = std::abs(d - static_cast<float>(20 * state->grid.size));
  const auto near = std::make_shared<std::vector<std::uint8_t>>(surface.primitives.size());
  return {[=] { state->outlines.near(state->distance, 20.3 * state->grid.size, *near); },
          [near] { return bits_of(*near); }};
}

// A disk that rolls around the surface, touching hardly anything.
PreparedTrial depths(const Device& device, const FacetSurface& surface) {
  struct State {
    std::vector<Segment2> segments, centres;
    RollingDisk disk;
    std::vector<float> depth;
  };
  const auto state = std::make_shared<State>();
  for (const Primitive& p : surface.primitives) {
    const Vec3d& a = surface.points[p.corner[0]];
    const Vec3d& b = surface.points[p.corner[1]];
    state->segments.push_back({{a.x, a.y}, {b.x, b.y}});
  }
  const CellGrid grid = grid_over(surface);
  const double side = grid.size * static_cast<double>(grid.columns);
  const Point2 middle = grid.origin + Point2{side, side} * 0.5;
  constexpr int around = 200;
  for (int i = 0; i < around; ++i) {
    const Point2 out{around - 2.0 * i, i % 7 * (i < around / 2 ? 40.0 : -40.0)};
    const Point2 from = middle + out * (0.8 * side / length(out));
    state->centres.push_back({from, i % 3 == 0 ? from + Point2{side / around, side / around} : from});
  }
  state->disk = {side / 4, side / 4, 0};
  return {[=] {
            const SegmentGrid grid_of_segments(state->segments, side / 200);
            const RollingDepth rolling(device, grid_of_segments.lists(), state->segments);
            state->depth = rolling.along(state->centres, state->disk);
          },
          [state] { return bits_of(state->depth); }};
}

PreparedTrial dexels(const Device& device, const FacetSurface& surface) {
  struct State {
    std::vector<Point2> points;
    std::vector<PlanEdge> edges;
    DexelLines lines;
    double radius = 0;
    Dexels found;
  };
  const auto state = std::make_shared<State>();
  for (const Vec3d& p : surface.points) state->points.push_back({p.x, p.y});
  for (std::size_t i = 1; i < state->points.size(); ++i) {
    const Point2 a = state->points[i - 1], b = state->points[i];
    if (i % 3 != 0 && !(a == b)) state->edges.push_back({a, b});
  }
  const CellGrid grid = grid_over(surface);
  state->lines = {grid.origin.y, grid.size, grid.rows};
  state->radius = 20 * grid.size;
  return {
      [=] { state->found = offset_dexels(device, state->points, state->edges, state->lines, state->radius); },
      [state] { return bits_of(state->found.all); }};
}

// Of coordinates, small and huge.
PreparedTrial angles(const Device& device, const FacetSurface& surface) {
  struct State {
    std::vector<double> numbers;
    std::vector<AngleValues> found;
  };
  const auto state = std::make_shared<State>();
  for (const Vec3d& p : surface.points)
    for (const double x : {p.x, p.y / 16, 0x1p9 * p.z, 0x1p60 * p.x}) state->numbers.push_back(x);
  return {[=] { state->found = angle_values(device, state->numbers); },
          [state] { return bits_of(state->found); }};
}

constexpr std::array trials{QueryTrial{"tree build", tree},
                            QueryTrial{"largest balls", spheres},
                            QueryTrial{"rays", rays},
                            QueryTrial{"closest points", nearest},
                            QueryTrial{"plan projection", projection},
                            QueryTrial{"outline raster", raster},
                            QueryTrial{"distance transform", distances},
                            QueryTrial{"facets near", near_facets},
                            QueryTrial{"contact depths", depths},
                            QueryTrial{"dexels", dexels},
                            QueryTrial{"angles", angles}};

}  // namespace

std::span<const QueryTrial> query_trials() { return trials; }

}  // namespace gabarit
