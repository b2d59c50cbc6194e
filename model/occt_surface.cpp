#include "model/occt_surface.h"

#include <algorithm>

#include <GeomConvert.hxx>
#include <GeomConvert_ApproxSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Standard_NotImplemented.hxx>

#include "model/brep_spline.h"
#include "model/occt_geometry.h"

namespace gabarit {
namespace {

void set_domain(Surface& s, const Handle(Geom_Surface) & surface) {
  surface->Bounds(s.domain.u0, s.domain.u1, s.domain.v0, s.domain.v1);
  s.u_periodic = surface->IsUPeriodic();
  s.v_periodic = surface->IsVPeriodic();
  for (double* bound : {&s.domain.u0, &s.domain.u1, &s.domain.v0, &s.domain.v1})
    *bound = finite_or_infinite(*bound);
}

Surface spline(Brep& brep, const Handle(Geom_BSplineSurface) & original) {
  Surface s;
  s.kind = SurfaceKind::spline;
  set_domain(s, original);
  const Handle(Geom_BSplineSurface) b = Handle(Geom_BSplineSurface)::DownCast(original->Copy());
  // OpenCASCADE 7.6 leaves weights of 0 in what was periodic without any.
  const bool rational = original->IsURational() || original->IsVRational();
  if (b->IsUPeriodic()) b->SetUNotPeriodic();
  if (b->IsVPeriodic()) b->SetVNotPeriodic();
  s.u_degree = b->UDegree(), s.v_degree = b->VDegree();
  if (s.u_degree > highest_degree || s.v_degree > highest_degree)
    throw Standard_NotImplemented("a spline surface of more than degree 25");
  s.u_poles = b->NbUPoles(), s.v_poles = b->NbVPoles();
  s.first_u_knot = add_knots(brep, b->UKnotSequence());
  s.first_v_knot = add_knots(brep, b->VKnotSequence());
  s.first_pole = static_cast<std::uint32_t>(brep.poles.size());
  brep.poles.reserve(brep.poles.size() +
                     static_cast<std::size_t>(s.u_poles) * static_cast<std::size_t>(s.v_poles));
  for (int i = 1; i <= s.u_poles; ++i) {
    for (int j = 1; j <= s.v_poles; ++j)
      brep.poles.push_back(pole(b->Pole(i, j), rational ? b->Weight(i, j) : 1.0));
  }
  return s;
}

Handle(Geom_BSplineSurface)
    approximation(Brep& brep, const Handle(Geom_Surface) & surface, const ParameterBox& r) {
  const Handle(Geom_Surface) piece = new Geom_RectangularTrimmedSurface(surface, r.u0, r.u1, r.v0, r.v1);
  const GeomConvert_ApproxSurface fit(piece, approximation_tolerance, GeomAbs_C2, GeomAbs_C2, 9, 9, 1000, 1);
  if (!fit.HasResult()) throw Standard_NotImplemented(surface->DynamicType()->Name());
  ++brep.approximated;
  // Measured on a grid: the error that OpenCASCADE itself gives was seen to be a hundred times too small.
  constexpr int steps = 64;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      const double u = r.u0 + (r.u1 - r.u0) * i / steps, v = r.v0 + (r.v1 - r.v0) * j / steps;
      const double error = surface->Value(u, v).Distance(fit.Surface()->Value(u, v));
      brep.approximation_error = std::max(brep.approximation_error, error);
    }
  }
  return fit.Surface();
}

template <class G>
Handle(G) as(const Handle(Geom_Surface) & surface) {
  return Handle(G)::DownCast(surface);
}

// False when it is none of the kinds with a position and up to two numbers.
bool set_elementary(Surface& s, const Handle(Geom_Surface) & surface) {
  if (const auto plane = as<Geom_Plane>(surface); !plane.IsNull()) {
    s.kind = SurfaceKind::plane;
  } else if (const auto cylinder = as<Geom_CylindricalSurface>(surface); !cylinder.IsNull()) {
    s.kind = SurfaceKind::cylinder, s.radius = cylinder->Radius();
  } else if (const auto cone = as<Geom_ConicalSurface>(surface); !cone.IsNull()) {
    s.kind = SurfaceKind::cone, s.radius = cone->RefRadius(), s.minor = cone->SemiAngle();
  } else if (const auto sphere = as<Geom_SphericalSurface>(surface); !sphere.IsNull()) {
    s.kind = SurfaceKind::sphere, s.radius = sphere->Radius();
  } else if (const auto torus = as<Geom_ToroidalSurface>(surface); !torus.IsNull()) {
    s.kind = SurfaceKind::torus, s.radius = torus->MajorRadius(), s.minor = torus->MinorRadius();
  } else {
    return false;
  }
  s.axes = axes_of(as<Geom_ElementarySurface>(surface)->Position());
  return true;
}

bool set_swept(Brep& brep, Surface& s, const Handle(Geom_Surface) & surface) {
  if (const auto extrusion = as<Geom_SurfaceOfLinearExtrusion>(surface); !extrusion.IsNull()) {
    s.kind = SurfaceKind::extrusion;
    s.axes.z = vector_of(extrusion->Direction());
    s.curve = add_curve(brep, extrusion->BasisCurve());
  } else if (const auto revolution = as<Geom_SurfaceOfRevolution>(surface); !revolution.IsNull()) {
    s.kind = SurfaceKind::revolution;
    s.axes.origin = vector_of(revolution->Location());
    s.axes.z = vector_of(revolution->Direction());
    s.curve = add_curve(brep, revolution->BasisCurve());
  } else {
    return false;
  }
  return true;
}

Surface converted(Brep& brep, const Handle(Geom_Surface) & surface, const ParameterBox& range) {
  Surface s;
  if (set_elementary(s, surface) || set_swept(brep, s, surface)) return set_domain(s, surface), s;
  if (const auto b = as<Geom_BSplineSurface>(surface); !b.IsNull()) return spline(brep, b);
  if (!as<Geom_BezierSurface>(surface).IsNull())
    return spline(brep, GeomConvert::SurfaceToBSplineSurface(surface));
  if (const auto trimmed = as<Geom_RectangularTrimmedSurface>(surface); !trimmed.IsNull())
    return converted(brep, trimmed->BasisSurface(), range);
  if (const auto offset = as<Geom_OffsetSurface>(surface); !offset.IsNull()) {
    if (const Handle(Geom_Surface) same = offset->Surface(); !same.IsNull())
      return converted(brep, same, range);
  }
  return spline(brep, approximation(brep, surface, range));
}

}  // namespace

std::uint32_t add_surface(Brep& brep, const Handle(Geom_Surface) & surface, const ParameterBox& range) {
  brep.surfaces.push_back(converted(brep, surface, range));
  return static_cast<std::uint32_t>(brep.surfaces.size() - 1);
}

}  // namespace gabarit
