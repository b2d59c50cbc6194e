#include <algorithm>

#include <GeomConvert.hxx>
#include <GeomConvert_ApproxCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Standard_NotImplemented.hxx>

#include "model/brep_spline.h"
#include "model/occt_geometry.h"
#include "model/occt_surface.h"

namespace gabarit {
namespace {

template <class G>
Handle(G) as(const Handle(Geom_Curve) & curve) {
  return Handle(G)::DownCast(curve);
}

void set_domain(Curve& c, const Handle(Geom_Curve) & curve) {
  c.periodic = curve->IsPeriodic();
  c.first = finite_or_infinite(curve->FirstParameter());
  c.last = finite_or_infinite(curve->LastParameter());
}

Curve spline(Brep& brep, const Handle(Geom_BSplineCurve) & original) {
  Curve c;
  c.kind = CurveKind::spline;
  set_domain(c, original);
  const Handle(Geom_BSplineCurve) b = Handle(Geom_BSplineCurve)::DownCast(original->Copy());
  if (b->IsPeriodic()) b->SetNotPeriodic();
  c.degree = b->Degree(), c.pole_count = b->NbPoles();
  if (c.degree > highest_degree) throw Standard_NotImplemented("a spline curve of more than degree 25");
  c.first_knot = add_knots(brep, b->KnotSequence());
  c.first_pole = static_cast<std::uint32_t>(brep.poles.size());
  for (int i = 1; i <= c.pole_count; ++i) brep.poles.push_back(pole(b->Pole(i), b->Weight(i)));
  return c;
}

bool set_conic(Curve& c, const Handle(Geom_Curve) & curve) {
  if (const auto circle = as<Geom_Circle>(curve); !circle.IsNull()) {
    c.kind = CurveKind::circle, c.radius = circle->Radius();
  } else if (const auto ellipse = as<Geom_Ellipse>(curve); !ellipse.IsNull()) {
    c.kind = CurveKind::ellipse, c.radius = ellipse->MajorRadius(), c.minor = ellipse->MinorRadius();
  } else if (const auto hyperbola = as<Geom_Hyperbola>(curve); !hyperbola.IsNull()) {
    c.kind = CurveKind::hyperbola, c.radius = hyperbola->MajorRadius(), c.minor = hyperbola->MinorRadius();
  } else if (const auto parabola = as<Geom_Parabola>(curve); !parabola.IsNull()) {
    c.kind = CurveKind::parabola, c.radius = parabola->Focal();
  } else {
    return false;
  }
  c.axes = axes_of(as<Geom_Conic>(curve)->Position());
  return true;
}

Curve converted(Brep& brep, const Handle(Geom_Curve) & curve) {
  Curve c;
  if (const auto line = as<Geom_Line>(curve); !line.IsNull()) {
    c.axes.origin = vector_of(line->Position().Location());
    c.axes.x = vector_of(line->Position().Direction());
    return set_domain(c, curve), c;
  }
  if (set_conic(c, curve)) return set_domain(c, curve), c;
  if (const auto b = as<Geom_BSplineCurve>(curve); !b.IsNull()) return spline(brep, b);
  if (!as<Geom_BezierCurve>(curve).IsNull()) return spline(brep, GeomConvert::CurveToBSplineCurve(curve));
  if (const auto trimmed = as<Geom_TrimmedCurve>(curve); !trimmed.IsNull())
    return converted(brep, trimmed->BasisCurve());
  const GeomConvert_ApproxCurve fit(curve, approximation_tolerance, GeomAbs_C2, 1000, 9);
  if (!fit.HasResult()) throw Standard_NotImplemented(curve->DynamicType()->Name());
  ++brep.approximated;
  constexpr int steps = 256;
  for (int i = 0; i <= steps; ++i) {
    const double t = curve->FirstParameter() + (curve->LastParameter() - curve->FirstParameter()) * i / steps;
    brep.approximation_error =
        std::max(brep.approximation_error, curve->Value(t).Distance(fit.Curve()->Value(t)));
  }
  return spline(brep, fit.Curve());
}

}  // namespace

std::uint32_t add_curve(Brep& brep, const Handle(Geom_Curve) & curve) {
  const Curve c = converted(brep, curve);
  brep.curves.push_back(c);
  return static_cast<std::uint32_t>(brep.curves.size() - 1);
}

}  // namespace gabarit
