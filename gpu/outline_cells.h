// The cells of a grid that the outlines of facets pass through in plan.
#pragma once

#include <span>

#include "gpu/buffer.h"
#include "gpu/cell_grid.h"
#include "gpu/plan_mesh.h"

namespace gabarit {

// An outline stands for its corners and points between them no further apart than a cell. The grid must hold
// what the height band leaves of all facets, and have fewer than 2^31 cells.
class OutlineCells {
 public:
  // `mesh`: views of the device's memory, which must outlive this.
  OutlineCells(const Device& device, const PlanMesh& mesh, const CellGrid& grid);

  // Sets to 1 the cells that hold a point of any outline.
  void mark(std::span<std::uint8_t> cells) const;
  // By facet: 1 when a point of its outline lies in a cell whose distance is at most `most`, else 0.
  // Distances between cells must not differ by more than their middles are apart.
  void near(std::span<const float> distance, double most, std::span<std::uint8_t> facets) const;

 private:
  Device device_;
  CellGrid grid_;
  PlanMesh mesh_;
  Buffer<std::int32_t> at_;  // the cell of each point; negative outside the height band
};

}  // namespace gabarit
