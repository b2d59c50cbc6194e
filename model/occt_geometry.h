// Small translations of OpenCASCADE's geometry.
#pragma once

#include <limits>

#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pnt.hxx>

#include "model/brep.h"

namespace gabarit {

constexpr double approximation_tolerance = 1e-6;  // mm, of the kinds that a Brep does not have

inline Vec3d vector_of(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }
inline Vec3d vector_of(const gp_Pnt& p) { return vector_of(p.XYZ()); }
inline Vec3d vector_of(const gp_Dir& p) { return vector_of(p.XYZ()); }
inline gp_Pnt point_of(const Vec3d& p) { return {p.x, p.y, p.z}; }
inline Axes axes_of(const gp_Ax3& at) {
  return {vector_of(at.Location()), vector_of(at.XDirection()), vector_of(at.YDirection()),
          vector_of(at.Direction())};
}
inline double finite_or_infinite(double bound) {
  return !Precision::IsInfinite(bound) ? bound
                                       : std::copysign(std::numeric_limits<double>::infinity(), bound);
}
inline Pole pole(const gp_Pnt& p, double weight) {
  return {p.X() * weight, p.Y() * weight, p.Z() * weight, weight};
}
inline std::uint32_t add_knots(Brep& brep, const TColStd_Array1OfReal& knots) {
  const auto first = static_cast<std::uint32_t>(brep.knots.size());
  brep.knots.insert(brep.knots.end(), knots.begin(), knots.end());
  return first;
}

}  // namespace gabarit
