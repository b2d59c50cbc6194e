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

// Facets with corners of their own, in the memory of a device; numbered anew.
struct PlanCopy {
  Buffer<Vec3d> points;
  Buffer<std::array<std::uint32_t, 3>> facets;
  double from, to;

  PlanMesh mesh() const { return {points.view(), facets.view(), from, to}; }
};

// Where there is room for them, all facets stay in the memory of the device; else they are copied in parts,
// each time that they are looked at.
class PlanFacets {
 public:
  // The band reaches from height `from` to height `to`, which may be infinite. `points` and `facets` must
  // outlive this. Throws DeviceError, and OutOfDeviceMemory when not even few facets fit.
  PlanFacets(const Device& device, std::span<const Vec3d> points,
             std::span<const std::array<std::uint32_t, 3>> facets, const PlanAxes& axes, double from,
             double to);

  const Device& device() const { return device_; }
  const PlanExtent& extent() const { return extent_; }
  std::int64_t size() const { return static_cast<std::int64_t>(facets_here_.size()); }

  bool stay() const { return stay_; }
  PlanMesh mesh() const;  // views of the device's memory; only when they stay there
  PlanCopy copy(std::int64_t begin, std::int64_t end) const;
  PlanCopy copy(std::span<const std::uint32_t> chosen) const;

 private:
  using Corners = std::array<std::uint32_t, 3>;

  bool take_there();
  template <class FacetAt>
  PlanCopy copy_of(std::int64_t n, FacetAt&& facet_at) const;
  PlanExtent find_extent() const;

  Device device_;
  std::span<const Vec3d> points_here_;
  std::span<const Corners> facets_here_;
  PlanAxes axes_;
  double from_, to_;
  bool stay_ = true;
  Buffer<Corners> facets_;
  Buffer<Vec3d> points_;
  PlanExtent extent_;
};

// How many facets are worth a copy of their own.
constexpr std::int64_t facets_of_a_copy = 256;

}  // namespace gabarit
