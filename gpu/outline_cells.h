// The cells of a grid that the outlines of facets pass through in plan.
#pragma once

#include <span>

#include "gpu/buffer.h"
#include "gpu/cell_grid.h"
#include "gpu/plan_facets.h"

namespace gabarit {

// An outline stands for its corners and points between them no further apart than a cell. The grid must hold
// what the height band leaves of all facets, and have fewer than 2^31 cells. What does not fit into the
// memory of the device at once is done for bands of rows of cells, and in each for parts of the facets.
class OutlineCells {
 public:
  // `plan` must outlive this. Throws DeviceError, as do both others, which throw OutOfDeviceMemory when not
  // even few facets and one row fit.
  OutlineCells(const PlanFacets& plan, const CellGrid& grid);

  // Sets to 1 the cells that hold a point of any outline.
  void mark(std::span<std::uint8_t> cells) const;
  // By facet: 1 when a point of its outline lies in a cell whose distance is at most `most`, else 0.
  // Distances between cells must not differ by more than their middles are apart.
  void near(std::span<const float> distance, double most, std::span<std::uint8_t> facets) const;

 private:
  bool take_there();
  template <class Work>
  void in_parts(Work&& work) const;

  const PlanFacets* plan_;
  CellGrid grid_;
  Buffer<std::int32_t> at_;  // the cell of each point; negative outside the height band
  bool stay_;                // the facets and these cells, in the memory of the device
};

}  // namespace gabarit
