#include <algorithm>
#include <cmath>
#include <limits>

#include "gpu/batches.h"
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

// `width`: columns that go together. `slots`: rows that are in work at the same time.
void count_columns(const Device& device, View<const std::uint8_t> marked, View<float> count,
                   std::int64_t columns, std::int64_t width) {
  parallel_for(device, (columns + width - 1) / width,
               ColumnCounts{marked, count, columns, marked.size / columns, width}, 1);
}
void measure_rows(const Device& device, View<float> distance, const CellGrid& grid, std::int64_t slots) {
  auto envelopes = Buffer<Parabola>::of_size(device, slots * grid.columns);
  parallel_for(device, slots,
               RowDistances{distance, envelopes.view(), grid.columns, distance.size / grid.columns, slots,
                            static_cast<float>(grid.size)},
               1);
}

// Row by row as many columns as the narrower one has.
template <class T>
void copy_columns(std::span<const T> from, std::int64_t from_columns, std::span<T> to,
                  std::int64_t to_columns, std::int64_t rows) {
  const std::int64_t count = std::min(from_columns, to_columns);
  for (std::int64_t y = 0; y < rows; ++y)
    std::copy_n(from.begin() + y * from_columns, count, to.begin() + y * to_columns);
}

// A strip of columns holds all that its counts depend on.
void count_strip(const Device& device, const CellGrid& grid, std::span<const std::uint8_t> marked,
                 std::span<float> count, std::int64_t begin, std::int64_t end) {
  const std::int64_t columns = end - begin;
  const auto first = static_cast<std::size_t>(begin), cells = static_cast<std::size_t>(columns * grid.rows);
  std::vector<std::uint8_t> strip(cells);
  copy_columns(marked.subspan(first), grid.columns, std::span(strip), columns, grid.rows);
  const Buffer<std::uint8_t> marks(device, std::span<const std::uint8_t>(strip));
  auto counts = Buffer<float>::of_size(device, marks.size());
  count_columns(device, marks.view(), counts.view(), columns, 1);
  const std::vector<float> counted = std::move(counts).read();
  copy_columns(std::span(counted), columns, count.subspan(first), grid.columns, grid.rows);
}

// The same numbers by way of the host: columns in strips, rows in bands.
void transform_in_parts(const Device& device, const CellGrid& grid, std::span<const std::uint8_t> marked,
                        std::span<float> distance) {
  in_batches(grid.columns, 1, [&](std::int64_t begin, std::int64_t end) {
    count_strip(device, grid, marked, distance, begin, end);
  });
  in_batches(grid.rows, 1, [&](std::int64_t begin, std::int64_t end) {
    const auto band = distance.subspan(static_cast<std::size_t>(begin * grid.columns),
                                       static_cast<std::size_t>((end - begin) * grid.columns));
    Buffer<float> there(device, std::span<const float>(band));
    measure_rows(device, there.view(), grid, end - begin);
    there.read(band);
  });
}

}  // namespace

void distance_transform(const Device& device, const CellGrid& grid, std::span<const std::uint8_t> marked,
                        std::span<float> distance) {
  // A processor core takes many columns and rows at once, to use its caches; a GPU has threads for each.
  if (!device.has_own_memory()) {
    count_columns(device, view(marked), view(distance), grid.columns, 64);
    return measure_rows(device, view(distance), grid, std::min<std::int64_t>(grid.rows, 64));
  }
  try {
    const Buffer<std::uint8_t> marks(device, marked);
    auto answers = Buffer<float>::of_size(device, grid.count());
    count_columns(device, marks.view(), answers.view(), grid.columns, 1);
    measure_rows(device, answers.view(), grid, grid.rows);
    answers.read(distance);
  } catch (const OutOfDeviceMemory&) {
    transform_in_parts(device, grid, marked, distance);
  }
}

}  // namespace gabarit
