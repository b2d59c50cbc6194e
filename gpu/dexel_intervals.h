// The intervals in which a line crosses disks and rectangles, and their union.
#pragma once

#include <cmath>

#include "gpu/dexel.h"

namespace gabarit {

// Empty unless from < to.
GABARIT_HD inline Dexel across_disk(Point2 centre, double radius, double y) {
  const double beside = y - centre.y;
  if (!(std::abs(beside) < radius)) return {0, 0};
  const double half = std::sqrt((radius - beside) * (radius + beside));
  return {centre.x - half, centre.x + half};
}

// Keeps what has low < value + slope * x < high.
GABARIT_HD inline void cut_to_slab(Dexel& part, double value, double slope, double low, double high) {
  // A line beside the slab or in it, as near as directions are told apart.
  if (std::abs(slope) < 1e-12) {
    if (!(low < value && value < high)) part.to = part.from;
    return;
  }
  const double u = (low - value) / slope;
  const double v = (high - value) / slope;
  const double first = u < v ? u : v;
  const double last = u < v ? v : u;
  if (first > part.from) part.from = first;
  if (last < part.to) part.to = last;
}

// Along an edge, reaching as far as a radius to both sides.
struct Rectangle {
  Point2 from, along;  // a unit vector
  double size;

  GABARIT_HD static Rectangle of(const PlanEdge& edge) {
    const Point2 whole = edge.to - edge.from;
    const double size = length(whole);
    return {edge.from, whole * (1 / size), size};
  }
};

GABARIT_HD inline Dexel across_rectangle(const Rectangle& rectangle, double radius, double y) {
  const Point2 along = rectangle.along;
  const double up = y - rectangle.from.y;
  Dexel part{-1e300, 1e300};
  cut_to_slab(part, up * along.y, along.x, 0, rectangle.size);
  cut_to_slab(part, up * along.x, -along.y, -radius, radius);
  return part.from < part.to ? Dexel{rectangle.from.x + part.from, rectangle.from.x + part.to} : Dexel{0, 0};
}

// A union of intervals in memory of fixed size, ascending and disjoint. Every end is an end that was given.
struct DexelUnion {
  Dexel* list;
  std::int64_t capacity;
  std::int64_t size = 0;
  bool overflow = false;

  GABARIT_HD bool covers(double from, double to) const {
    for (std::int64_t i = 0; i < size; ++i) {
      if (list[i].to >= to) return list[i].from <= from;
    }
    return false;
  }
  GABARIT_HD void add(Dexel part) {
    if (!(part.from < part.to)) return;
    std::int64_t begin = size;
    while (begin > 0 && list[begin - 1].to > part.from) --begin;
    std::int64_t end = begin;
    while (end < size && list[end].from < part.to) ++end;
    if (begin == end) return insert(begin, part);
    if (list[begin].from < part.from) part.from = list[begin].from;
    if (list[end - 1].to > part.to) part.to = list[end - 1].to;
    list[begin] = part;
    for (std::int64_t i = end; i < size; ++i) list[i - (end - begin - 1)] = list[i];
    size -= end - begin - 1;
  }

 private:
  GABARIT_HD void insert(std::int64_t place, const Dexel& part) {
    if (size == capacity) {
      overflow = true;
      return;
    }
    for (std::int64_t i = size++; i > place; --i) list[i] = list[i - 1];
    list[place] = part;
  }
};

}  // namespace gabarit
