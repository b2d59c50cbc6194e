#include "checks/facet_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// A value this near to its bound is settled, as a share of it; where the surface is curved the bound stays
// behind, however small the cell.
constexpr double settled_on_planes = 1e-3, settled_on_curves = 0.05;
// Cells smaller than this share of the value tell nothing new.
constexpr double fine_enough = 1.0 / 16;
constexpr double finer_at_the_limit = 1.0 / 8, coarser_where_clear = 8;
constexpr std::size_t block = 1 << 17;
constexpr std::size_t most_cuts = 4'000'000;

// A part of a facet, its corners as weights of the facet's second and third corner.
struct Cell {
  std::uint32_t row = 0;
  std::array<std::array<float, 2>, 3> corner{{{0, 0}, {1, 0}, {0, 1}}};
};

Vec3d blend(const std::array<Vec3d, 3>& of, double v, double w) {
  return of[0] + v * (of[1] - of[0]) + w * (of[2] - of[0]);
}
Vec3d to_double(const Vec3f& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
double angle_between(const Vec3d& m, const Vec3d& n) { return std::atan2(length(cross(m, n)), dot(m, n)); }

class CellMeasurement {
 public:
  CellMeasurement(const TriangleMesh& mesh, const ContactSurface& surface, const CellOptions& options,
                  const Probe& probe)
      : mesh_(mesh), surface_(surface), options_(options), probe_(probe) {}

  Field run(const Region& region) {
    begin(region);
    const std::vector<Cell> cells = cells_in_tree_order();
    for (std::size_t i = 0; i < cells.size(); i += block) {
      settle({cells.begin() + static_cast<std::ptrdiff_t>(i),
              cells.begin() + static_cast<std::ptrdiff_t>(std::min(i + block, cells.size()))});
      if (options_.progress)
        options_.progress(static_cast<double>(std::min(i + block, cells.size())) /
                          static_cast<double>(cells.size()));
    }
    mark_buried();
    if (cut_off_) {
      field_.notes.push_back(fmt::format(
          "Large facets were looked at in {} places only; the bounds allow for what lies between.",
          most_cuts));
    }
    return std::move(field_);
  }

 private:
  bool smallest() const { return options_.extreme == Extreme::smallest; }

  // Facets without a normal are done.
  void begin(const Region& region) {
    for (FacetId f = 0; f < region.facets.size(); ++f)
      if (region.facets[f] != Selected::no) field_.facets.push_back(f);
    field_.resize(field_.size());
    buried_.assign(field_.size(), 0);
    for (std::size_t row = 0; row < field_.size(); ++row) {
      const FacetId f = field_.facets[row];
      const bool normal = surface_.normals[f][0] != Vec3f{};
      field_.absence[row] = normal ? Absence::none : Absence::degenerate;
      field_.value[row] = normal ? (smallest() ? infinity : -1) : std::numeric_limits<double>::quiet_NaN();
      field_.lower[row] = normal && smallest() ? infinity : 0;
      field_.upper[row] = normal && !smallest() ? 0 : infinity;
      field_.at[row] = field_.contact[row] = mesh_.centroid(f);
    }
  }

  std::vector<Cell> cells_in_tree_order() const {
    constexpr std::uint32_t none = 0xffffffffU;
    std::vector<std::uint32_t> row(mesh_.facet_count(), none);
    for (std::size_t i = 0; i < field_.size(); ++i) row[field_.facets[i]] = static_cast<std::uint32_t>(i);
    std::vector<Cell> cells;
    cells.reserve(field_.size());
    for (const std::uint32_t id : surface_.tree.order())
      if (id < row.size() && row[id] != none) cells.push_back({.row = row[id]});
    return cells;
  }

  // Measures the cells and what they are cut into.
  void settle(std::vector<Cell> cells) {
    std::vector<CellQuery> queries;
    std::vector<CellAnswer> answers;
    std::vector<double> sides;
    while (!cells.empty()) {
      queries.resize(cells.size());
      sides.resize(cells.size());
      answers.assign(cells.size(), {});
      parallel_for_cpu(
          surface_.tree.device(), static_cast<std::int64_t>(cells.size()),
          [&](std::int64_t i) {
            const auto k = static_cast<std::size_t>(i);
            queries[k] = query(cells[k]);
            sides[k] = longest_side(cells[k]).second;
          },
          4096);
      probe_(queries, answers);
      for (std::size_t i = 0; i < cells.size(); ++i) keep_value(cells[i].row, queries[i], answers[i]);
      std::vector<Cell> halves;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (is_settled(cells[i], queries[i], sides[i], answers[i]))
          keep_bounds(cells[i].row, answers[i]);
        else
          cut(cells[i], halves);
      }
      cells = std::move(halves);
    }
  }

  // Nothing was measured where every cell is buried; what they read is a lower bound all the same.
  void mark_buried() {
    for (std::size_t row = 0; row < field_.size(); ++row) {
      if (buried_[row] == 0 || field_.absence[row] != Absence::none || field_.value[row] < infinity) continue;
      field_.absence[row] = Absence::buried;
      field_.value[row] = std::numeric_limits<double>::quiet_NaN();
    }
  }

  CellQuery query(const Cell& cell) const {
    const FacetId f = field_.facets[cell.row];
    const std::array<Vec3d, 3> corners = mesh_.corners(f);
    std::array<Vec3d, 3> normals;
    for (std::size_t k = 0; k < 3; ++k) normals[k] = to_double(surface_.normals[f][k]);
    double v = 0, w = 0;
    for (const auto& c : cell.corner) v += static_cast<double>(c[0]) / 3, w += static_cast<double>(c[1]) / 3;
    CellQuery query;
    query.point = cell_is_whole(cell) ? mesh_.centroid(f) : blend(corners, v, w);
    const Vec3d own = facet_normal(mesh_, f);
    const Vec3d mean = normalized(blend(normals, v, w));
    double spacing = 0, spread = 0, turn = 0;
    for (const Vec3d& n : normals) spread = std::max(spread, angle_between(own, n));
    const bool plane = spread < 1e-6;
    const Vec3d n = plane || !options_.smooth ? own : mean;
    for (const auto& c : cell.corner) {
      const double cv = c[0], cw = c[1];
      spacing = std::max(spacing, length(blend(corners, cv, cw) - query.point));
      if (!plane) turn = std::max(turn, angle_between(n, normalized(blend(normals, cv, cw))));
    }
    query.direction = options_.side == Side::inside ? -n : n;
    query.across = options_.side == Side::inside ? -own : own;
    query.facet = f;
    query.weights = {v, w};
    query.known = field_.value[cell.row];
    query.known_upper = field_.upper[cell.row];
    query.sag = surface_.sag[f];
    query.spacing = static_cast<float>(spacing * (1 + 1e-6));
    query.tilt = plane ? 0.0F : static_cast<float>(std::min(0.49, std::max(turn, spread / 2)));
    return query;
  }

  static bool cell_is_whole(const Cell& cell) { return cell.corner == Cell{}.corner; }

  void keep_value(std::uint32_t row, const CellQuery& query, const CellAnswer& answer) {
    if (answer.absence == Absence::buried) {
      buried_[row] = 1;
      return;
    }
    if (answer.absence != Absence::none) field_.absence[row] = answer.absence;
    double& value = field_.value[row];
    if (smallest()) field_.upper[row] = std::min(field_.upper[row], answer.upper);
    if (!smallest()) field_.lower[row] = std::max(field_.lower[row], answer.lower);
    if (smallest() ? answer.value >= value : answer.value <= value) {
      if (value < infinity || !smallest()) return;
    }
    value = answer.value;
    field_.at[row] = answer.at.value_or(query.point);
    field_.contact[row] = answer.contact;
  }

  bool is_settled(const Cell& cell, const CellQuery& query, double side, const CellAnswer& answer) {
    const bool finer = answer.absence != Absence::buried && decides(cell, answer);
    const double share = finer ? finer_at_the_limit : answer.clear ? coarser_where_clear : 1.0;
    const double step = options_.step * share;
    if (field_.absence[cell.row] != Absence::none || side <= step) return true;
    if (!options_.exhaustive && answer.absence != Absence::buried) {
      const double value = field_.value[cell.row];
      const double near = query.tilt > 0 ? settled_on_curves : settled_on_planes;
      const bool known =
          smallest() ? answer.lower >= value * (1 - near) : answer.greatest <= value * (1 + near);
      if (known || side <= fine_enough * value) return true;
    }
    if (cuts_ >= most_cuts) return cut_off_ = true;
    ++cuts_;
    return false;
  }

  // Whether the limit lies within the cell's bounds, no other cell has broken it, and smaller cells would
  // tell: not where the sags alone leave it open at the very point.
  bool decides(const Cell& cell, const CellAnswer& answer) const {
    const double limit = options_.limit;
    const double apart = std::fabs(answer.value - limit);
    if (!(limit > 0)) return false;
    return smallest() ? answer.lower < limit && limit <= field_.upper[cell.row] &&
                            apart > answer.upper - answer.value
                      : answer.greatest > limit && limit >= field_.lower[cell.row] &&
                            apart > answer.value - answer.lower;
  }

  void keep_bounds(std::uint32_t row, const CellAnswer& answer) {
    if (smallest())
      field_.lower[row] = std::min(field_.lower[row], answer.lower);
    else
      field_.upper[row] = std::max(field_.upper[row], answer.greatest);
    if (field_.absence[row] == Absence::none) return;
    field_.value[row] = std::numeric_limits<double>::quiet_NaN();
    field_.lower[row] = 0;
    field_.upper[row] = infinity;
  }

  // Number of the side and its length, mm.
  std::pair<std::size_t, double> longest_side(const Cell& cell) const {
    const std::array<Vec3d, 3> corners = mesh_.corners(field_.facets[cell.row]);
    std::pair<std::size_t, double> longest{0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &a = cell.corner[k], &b = cell.corner[(k + 1) % 3];
      const double side = length(blend(corners, a[0], a[1]) - blend(corners, b[0], b[1]));
      if (side > longest.second) longest = {k, side};
    }
    return longest;
  }

  void cut(const Cell& cell, std::vector<Cell>& halves) const {
    const std::size_t k = longest_side(cell).first;
    const auto &a = cell.corner[k], &b = cell.corner[(k + 1) % 3];
    const std::array<float, 2> middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    Cell first = cell, second = cell;
    first.corner[(k + 1) % 3] = middle;
    second.corner[k] = middle;
    halves.push_back(first);
    halves.push_back(second);
  }

  const TriangleMesh& mesh_;
  const ContactSurface& surface_;
  const CellOptions& options_;
  const Probe& probe_;
  Field field_;
  std::vector<std::uint8_t> buried_;  // by row: whether a cell was
  std::size_t cuts_ = 0;
  bool cut_off_ = false;
};

}  // namespace

Field measure_cells(const TriangleMesh& mesh, const Region& region, const ContactSurface& surface,
                    const CellOptions& options, const Probe& probe) {
  return CellMeasurement(mesh, surface, options, probe).run(region);
}

}  // namespace gabarit
