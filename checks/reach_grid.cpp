#include "checks/reach_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gabarit {

static constexpr double diagonal = std::numbers::sqrt2;
static constexpr std::size_t most_cells = 16'000'000;

ReachGrid::ReachGrid(const PlanProjection& plan, double smallest, double largest, double tolerance) {
  const Point2 extent = plan.high() - plan.low();
  const double margin = 2 * largest;
  const double area = (extent.x + 2 * margin) * (extent.y + 2 * margin);
  size_ = std::max(smallest / 75, std::sqrt(area / static_cast<double>(most_cells)));
  const double border = margin + 4 * size_;
  origin_ = plan.low() - Point2{border, border};
  columns_ = static_cast<std::size_t>(std::ceil((extent.x + 2 * border) / size_)) + 1;
  rows_ = static_cast<std::size_t>(std::ceil((extent.y + 2 * border) / size_)) + 1;

  std::vector<std::uint8_t> cells(columns_ * rows_, 0);
  for (FacetId f = 0; f < plan.facet_count(); ++f) mark(plan.polygon(f), cells);
  // A place is free only if its distance is at least the radius; cell centres are off by a diagonal in all.
  // A hundredth of a cell more covers the rounding of the single-precision transform.
  cells = flood(distance_transform(cells), smallest - (diagonal + 0.01) * size_);
  distance_ = distance_transform(cells);
  reach_ = largest + tolerance + (diagonal + 0.51) * size_;
}

std::size_t ReachGrid::cell(Point2 p) const {
  const auto x = static_cast<std::size_t>((p.x - origin_.x) / size_);
  const auto y = static_cast<std::size_t>((p.y - origin_.y) / size_);
  return y * columns_ + x;
}

// Visits points of the outline no further apart than a cell.
template <class Visit>
static void for_each_sample(const PlanPolygon& polygon, double spacing, Visit&& visit) {
  for (int i = 0; i < polygon.size; ++i) {
    const Point2 a = polygon.corner[static_cast<std::size_t>(i)];
    visit(a);
    const Point2 ab = polygon.corner[static_cast<std::size_t>((i + 1) % polygon.size)] - a;
    const double l2 = dot(ab, ab);
    if (l2 <= spacing * spacing) continue;
    const auto steps = static_cast<int>(std::ceil(std::sqrt(l2) / spacing));
    for (int k = 1; k < steps; ++k) visit(a + ab * (static_cast<double>(k) / steps));
  }
}

void ReachGrid::mark(const PlanPolygon& polygon, std::vector<std::uint8_t>& cells) const {
  for_each_sample(polygon, size_, [&](Point2 p) { cells[cell(p)] = 1; });
}

bool ReachGrid::reached(const PlanPolygon& polygon) const {
  bool near = false;
  for_each_sample(polygon, size_, [&](Point2 p) { near = near || distance_[cell(p)] <= reach_; });
  return near;
}

// Places a quarter of a square apart lie in the same square or in neighbours, whose middles are at most a
// diagonal apart.
double ReachGrid::axis_gap(Point2 centre) const {
  const Point2 at = (centre - origin_) * (1 / size_);
  const bool inside =
      at.x >= 0 && at.y >= 0 && at.x < static_cast<double>(columns_) && at.y < static_cast<double>(rows_);
  return inside ? distance_[cell(centre)] - 1.5 * size_ : -1;
}

// From the border inwards, through corners as well.
std::vector<std::uint8_t> ReachGrid::flood(const std::vector<float>& distance, double free) const {
  std::vector<std::uint8_t> reached(distance.size(), 0);
  std::vector<std::size_t> open{0};
  reached[0] = 1;
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    const std::size_t x = at % columns_;
    const std::size_t y = at / columns_;
    for (std::size_t v = y > 0 ? y - 1 : 0; v <= std::min(y + 1, rows_ - 1); ++v) {
      for (std::size_t u = x > 0 ? x - 1 : 0; u <= std::min(x + 1, columns_ - 1); ++u) {
        const std::size_t next = v * columns_ + u;
        if (reached[next] == 0 && distance[next] >= free) {
          reached[next] = 1;
          open.push_back(next);
        }
      }
    }
  }
  return reached;
}

// One line of the squared Euclidean transform (Felzenszwalb and Huttenlocher, Distance Transforms of Sampled
// Functions, 2012).
static void transform_line(const std::vector<float>& f, std::size_t n, std::vector<float>& d,
                           std::vector<std::size_t>& v, std::vector<float>& z) {
  constexpr float far = std::numeric_limits<float>::infinity();
  std::size_t k = 0;
  std::size_t first = 0;
  while (first < n && f[first] == far) ++first;
  if (first == n) {
    std::fill_n(d.begin(), n, far);
    return;
  }
  v[0] = first;
  z[0] = -far;
  z[1] = far;
  const auto height = [&](std::size_t q) { return f[q] + static_cast<float>(q) * static_cast<float>(q); };
  for (std::size_t q = first + 1; q < n; ++q) {
    if (f[q] == far) continue;
    const auto crossing = [&] {
      return (height(q) - height(v[k])) / (2 * (static_cast<float>(q) - static_cast<float>(v[k])));
    };
    float s = crossing();
    while (s <= z[k]) {
      --k;
      s = crossing();
    }
    v[++k] = q;
    z[k] = s;
    z[k + 1] = far;
  }
  k = 0;
  for (std::size_t q = 0; q < n; ++q) {
    while (z[k + 1] < static_cast<float>(q)) ++k;
    const float step = static_cast<float>(q) - static_cast<float>(v[k]);
    d[q] = step * step + f[v[k]];
  }
}

std::vector<float> ReachGrid::distance_transform(const std::vector<std::uint8_t>& cells) const {
  constexpr float far = std::numeric_limits<float>::infinity();
  std::vector<float> out(cells.size());
  const std::size_t longest = std::max(columns_, rows_);
  std::vector<float> line(longest), result(longest), z(longest + 1);
  std::vector<std::size_t> v(longest);
  // Along y a running count is enough: the nearest marked cell of the column, above or below.
  for (std::size_t x = 0; x < columns_; ++x) out[x] = cells[x] != 0 ? 0 : far;
  for (std::size_t y = 1; y < rows_; ++y) {
    for (std::size_t x = 0, i = y * columns_; x < columns_; ++x, ++i)
      out[i] = cells[i] != 0 ? 0 : out[i - columns_] + 1;
  }
  for (std::size_t y = rows_ - 1; y-- > 0;) {
    for (std::size_t x = 0, i = y * columns_; x < columns_; ++x, ++i)
      out[i] = std::min(out[i], out[i + columns_] + 1);
  }
  for (std::size_t y = 0; y < rows_; ++y) {
    for (std::size_t x = 0; x < columns_; ++x) line[x] = out[y * columns_ + x] * out[y * columns_ + x];
    transform_line(line, columns_, result, v, z);
    for (std::size_t x = 0; x < columns_; ++x)
      out[y * columns_ + x] = std::sqrt(result[x]) * static_cast<float>(size_);
  }
  return out;
}

}  // namespace gabarit
