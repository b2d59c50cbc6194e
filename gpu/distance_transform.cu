#include <algorithm>
#include <cmath>
#include <limits>

#include "gpu/buffer.h"
#include "gpu/distance_transform.h"
#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

constexpr float far = std::numeric_limits<float>::infinity();

// Along a column a running count is enough: the nearest marked cell above or below. Neighbouring columns go
// together.
struct ColumnCounts {
  View<const std::uint8_t> marked;
  View<float> count;
  std::int64_t columns, rows, width;

  GABARIT_HD void operator()(std::int64_t strip) const {
    const std::int64_t begin = strip * width;
    const std::int64_t end = begin + width < columns ? begin + width : columns;
    for (std::int64_t x = begin; x < end; ++x) count[x] = marked[x] != 0 ? 0 : far;
    for (std::int64_t y = 1; y < rows; ++y) {
      const std::uint8_t* mark = marked.data + y * columns;
      float* here = count.data + y * columns;
      for (std::int64_t x = begin; x < end; ++x) here[x] = mark[x] != 0 ? 0 : here[x - columns] + 1;
    }
    for (std::int64_t y = rows - 1; y-- > 0;) {
      float* here = count.data + y * columns;
      for (std::int64_t x = begin; x < end; ++x) {
        const float below = here[x + columns] + 1;
        here[x] = below < here[x] ? below : here[x];
      }
    }
  }
};

// Over a row: the square of the distance from the nearest marked cell of one column. Lowest from `begin` on.
struct Parabola {
  double begin;
  float at, count;

  GABARIT_HD double height() const {
    return static_cast<double>(count) * count + static_cast<double>(at) * at;
  }
};

// Counts along columns become distances, row by row. All but roots and quotients are exact integers; a
// quotient is only compared with integers, too far from it for its rounding to matter.
struct RowDistances {
  View<float> distance;
  View<Parabola> envelopes;
  std::int64_t columns, rows, slots;
  float size;

  // A slot has an envelope of its own and takes every so many rows.
  GABARIT_HD void operator()(std::int64_t slot) const {
    Parabola* envelope = envelopes.data + slot * columns;
    for (std::int64_t y = slot; y < rows; y += slots) {
      float* line = distance.data + y * columns;
      evaluate(envelope, lowest(line, envelope), line);
    }
  }

 private:
  GABARIT_HD std::int64_t lowest(const float* count, Parabola* envelope) const {
    std::int64_t n = 0;
    for (std::int64_t x = 0; x < columns; ++x) {
      if (count[x] == far) continue;
      Parabola next{0, static_cast<float>(x), count[x]};
      for (; n > 0; --n) {
        const Parabola& last = envelope[n - 1];
        next.begin = (next.height() - last.height()) / (2 * (static_cast<double>(next.at) - last.at));
        if (next.begin > last.begin) break;
      }
      if (n == 0) next.begin = 0;
      envelope[n++] = next;
    }
    return n;
  }
  GABARIT_HD void evaluate(const Parabola* envelope, std::int64_t n, float* line) const {
    std::int64_t x = 0;
    for (std::int64_t k = 0; k < n; ++k) {
      const bool last = k + 1 == n || envelope[k + 1].begin >= static_cast<double>(columns);
      const std::int64_t end = last ? columns : static_cast<std::int64_t>(envelope[k + 1].begin) + 1;
      const float f = envelope[k].count * envelope[k].count;
      const float at = envelope[k].at;
      for (; x < end; ++x) {
        const float step = static_cast<float>(x) - at;
        line[x] = std::sqrt(step * step + f) * size;
      }
    }
    if (n == 0) {
      for (; x < columns; ++x) line[x] = far;
    }
  }
};

}  // namespace

void distance_transform(const Device& device, const CellGrid& grid, std::span<const std::uint8_t> marked,
                        std::span<float> distance) {
  const bool cpu = !device.has_own_memory();
  // A processor core takes many columns and rows at once, to use its caches; a GPU has threads for each.
  const std::int64_t width = cpu ? 64 : 1;
  const std::int64_t slots = cpu ? std::min<std::int64_t>(grid.rows, 64) : grid.rows;
  auto envelopes = Buffer<Parabola>::of_size(device, slots * grid.columns);
  const auto run = [&](View<const std::uint8_t> marks, View<float> out) {
    parallel_for(device, (grid.columns + width - 1) / width,
                 ColumnCounts{marks, out, grid.columns, grid.rows, width}, 1);
    parallel_for(
        device, slots,
        RowDistances{out, envelopes.view(), grid.columns, grid.rows, slots, static_cast<float>(grid.size)},
        1);
  };
  if (cpu) return run(view(marked), view(distance));
  const Buffer<std::uint8_t> marks(device, marked);
  auto answers = Buffer<float>::of_size(device, grid.count());
  run(marks.view(), answers.view());
  answers.read(distance);
}

}  // namespace gabarit
