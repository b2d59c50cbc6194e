// The facets of a mesh turned to its plan, in the memory of a device.
#pragma once

#include <limits>
#include <span>

#include "gpu/buffer.h"
#include "gpu/plan_axes.h"
#include "gpu/plan_mesh.h"

namespace gabarit {

// Of what a height band leaves of facets.
struct PlanExtent {
  Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point2 high{-low.x, -low.y};
  std::int64_t left_out = 0;  // facets with a corner that is not measurable

  GABARIT_HD bool empty() const { return !(low.x <= high.x); }
  GABARIT_HD void add(Point2 p) {
    low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y};
    high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y};
  }
};

class PlanFacets {
 public:
  // The band reaches from height `from` to height `to`, which may be infinite. On a CPU `facets` are looked
  // at where they are and must outlive this. Throws DeviceError and OutOfDeviceMemory.
  PlanFacets(const Device& device, std::span<const Vec3d> points,
             std::span<const std::array<std::uint32_t, 3>> facets, const PlanAxes& axes, double from,
             double to);

  const Device& device() const { return device_; }
  PlanMesh mesh() const;  // views of the device's memory
  const PlanExtent& extent() const { return extent_; }

 private:
  Device device_;
  std::span<const std::array<std::uint32_t, 3>> facets_here_;
  Buffer<std::array<std::uint32_t, 3>> facets_;
  Buffer<Vec3d> points_;
  double from_, to_;
  PlanExtent extent_;
};

}  // namespace gabarit
