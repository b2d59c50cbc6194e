#include "model/occt_trim.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomLib.hxx>
#include <ShapeFix_Edge.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Ax2.hxx>

#include "model/brep_trim.h"
#include "model/occt_surface.h"
#include "model/trim_loops.h"

namespace gabarit {
namespace {

constexpr double many_turns = 1000;

double tolerance_of(const TopoDS_Edge& edge) {
  double tolerance = BRep_Tool::Tolerance(edge);
  for (const TopoDS_Vertex& v : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
    if (!v.IsNull()) tolerance = std::max(tolerance, BRep_Tool::Tolerance(v));
  return tolerance;
}

Handle(Geom2d_Curve)
    curve_in_face(const TopoDS_Edge& edge, const TopoDS_Face& face, double& first, double& last) {
  Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull() && ShapeFix_Edge().FixAddPCurve(edge, face, BRep_Tool::IsClosed(edge, face)))
    curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  while (!curve.IsNull() && curve->IsKind(STANDARD_TYPE(Geom2d_TrimmedCurve)))
    curve = Handle(Geom2d_TrimmedCurve)::DownCast(curve)->BasisCurve();
  return curve;
}

Parameters parameters_of(const gp_Pnt2d& p) { return {p.X(), p.Y()}; }

// Forwards along the curve.
void follow(const Handle(Geom2d_Curve) & curve, TrimStretch& s, Brep& brep) {
  if (curve->IsKind(STANDARD_TYPE(Geom2d_Line))) {
    s.start = parameters_of(curve->Value(s.first)), s.end = parameters_of(curve->Value(s.last));
    return;
  }
  s.curve = add_curve(brep, GeomLib::To3d(gp_Ax2(gp::XOY()), curve));
  const Curve& ours = brep.curves[s.curve];
  if (!ours.periodic)
    s.first = std::clamp(s.first, ours.first, ours.last), s.last = std::clamp(s.last, ours.first, ours.last);
  s.start = trim_point(view(brep), ours, s.first), s.end = trim_point(view(brep), ours, s.last);
}

std::optional<TrimStretch> stretch_of(const TopoDS_Edge& edge, const TopoDS_Face& face, Brep& brep) {
  TrimStretch s;
  const Handle(Geom2d_Curve) curve = curve_in_face(edge, face, s.first, s.last);
  if (curve.IsNull() || !std::isfinite(s.first) || !std::isfinite(s.last)) return std::nullopt;
  if (curve->IsPeriodic() && !(s.last - s.first < many_turns * curve->Period())) return std::nullopt;
  follow(curve, s, brep);
  s.tolerance = tolerance_of(edge);
  if (edge.Orientation() == TopAbs_REVERSED) std::swap(s.start, s.end), std::swap(s.first, s.last);
  return s;
}

bool is_border(const TopoDS_Shape& shape) {
  return shape.Orientation() == TopAbs_FORWARD || shape.Orientation() == TopAbs_REVERSED;
}

}  // namespace

void add_trim(const TopoDS_Face& face, const std::function<EdgeId(const TopoDS_Edge&)>& number, Brep& brep) {
  // Whichever side of it is out: in its parameter plane the face lies on the left of its wires.
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  std::vector<TrimWire> wires;
  for (TopoDS_Iterator wire(forward); wire.More(); wire.Next()) {
    if (wire.Value().ShapeType() != TopAbs_WIRE || !is_border(wire.Value())) continue;
    wires.emplace_back();
    for (TopoDS_Iterator it(wire.Value()); it.More(); it.Next()) {
      if (!is_border(it.Value())) continue;
      const TopoDS_Edge edge = TopoDS::Edge(it.Value());
      std::optional<TrimStretch> stretch = stretch_of(edge, forward, brep);
      if (!stretch) return add_unknown_trim(brep);
      stretch->edge = number(edge);
      wires.back().push_back(*stretch);
    }
  }
  add_trim(wires, brep);
}

}  // namespace gabarit
