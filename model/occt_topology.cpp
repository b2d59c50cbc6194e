#include "model/occt_topology.h"

#include <algorithm>

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "model/brep_turn.h"
#include "model/occt_geometry.h"
#include "model/occt_surface.h"
#include "model/occt_trim.h"

namespace gabarit {
namespace {

// UVBounds can exceed the surface's domain.
ParameterBox range_of(const TopoDS_Face& face, const Handle(Geom_Surface) & surface) {
  ParameterBox range, domain;
  BRepTools::UVBounds(face, range.u0, range.u1, range.v0, range.v1);
  surface->Bounds(domain.u0, domain.u1, domain.v0, domain.v1);
  if (!surface->IsUPeriodic()) {
    range.u0 = std::clamp(range.u0, domain.u0, domain.u1);
    range.u1 = std::clamp(range.u1, domain.u0, domain.u1);
  }
  if (!surface->IsVPeriodic()) {
    range.v0 = std::clamp(range.v0, domain.v0, domain.v1);
    range.v1 = std::clamp(range.v1, domain.v0, domain.v1);
  }
  return range;
}

void add_face(const TopoDS_Face& face, std::uint32_t body, Brep& brep) {
  TopLoc_Location at;
  Handle(Geom_Surface) surface = BRep_Tool::Surface(face, at);
  if (surface.IsNull()) throw Standard_Failure("a face without a surface");
  if (!at.IsIdentity()) surface = Handle(Geom_Surface)::DownCast(surface->Transformed(at.Transformation()));
  Face f;
  f.range = range_of(face, surface);
  f.surface = add_surface(brep, surface, f.range);
  f.body = body;
  f.sign = face.Orientation() == TopAbs_REVERSED ? -1 : 1;
  f.tolerance = BRep_Tool::Tolerance(face);
  brep.faces.push_back(f);
}

// One side of an edge: how a face sees it.
struct Side {
  TopoDS_Edge edge;
  TopoDS_Face face;
  FaceId id;
};

Edge plain_edge(const TopoDS_Edge& edge, Brep& brep) {
  Edge e;
  TopLoc_Location at;
  Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, at, e.first, e.last);
  if (!curve.IsNull()) {
    if (!at.IsIdentity()) curve = Handle(Geom_Curve)::DownCast(curve->Transformed(at.Transformation()));
    e.curve = add_curve(brep, curve);
  }
  e.tolerance = BRep_Tool::Tolerance(edge);
  return e;
}

EdgeSide side_of(const Side& side, double t, const Brep& brep) {
  double first = 0, last = 0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(side.edge, side.face, first, last);
  if (curve.IsNull()) return {};
  const gp_Pnt2d uv = curve->Value(std::clamp(t, first, last));
  return {.face = side.id, .at = {uv.X(), uv.Y()}, .known = brep.faces[side.id].surface != no_number};
}

// The turn between both sides, at places along the edge that leave out its ends: there a surface may be
// singular.
void measure_turn(const std::array<Side, 2>& sides, const Brep& brep, Edge& e) {
  constexpr std::array places{0.01, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.99};
  const BrepView arrays = view(brep);
  const bool forward = sides[0].edge.Orientation() != TopAbs_REVERSED;
  bool first = true;
  for (const double place : places) {
    const double t = e.first + place * (e.last - e.first);
    const Vec3d along = curve_point(arrays, brep.curves[e.curve], t).d * (forward ? 1.0 : -1.0);
    const std::optional<double> turn =
        turn_across(arrays, side_of(sides[0], t, brep), side_of(sides[1], t, brep), along);
    if (!turn) continue;
    e.least_turn = first ? *turn : std::min(e.least_turn, *turn);
    e.greatest_turn = first ? *turn : std::max(e.greatest_turn, *turn);
    first = false;
  }
  e.kind = kind_of_turn(e.least_turn, e.greatest_turn);
}

class Topology {
 public:
  Topology(const TopoDS_Shape& shape, Brep& brep)
      : brep_(&brep), first_edge_(static_cast<EdgeId>(brep.edges.size())) {
    TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
    TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
    sides_.resize(static_cast<std::size_t>(edges_.Extent()) + 1);
    if (brep.first_edge_of_face.empty()) brep.first_edge_of_face.push_back(0);
  }

  void add_faces(const TopoDS_Shape& shape, std::uint32_t body) {
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
      const TopoDS_Face face = TopoDS::Face(it.Current());
      add_face(face, body, *brep_);
      const auto id = static_cast<FaceId>(brep_->faces.size() - 1);
      for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
        add_side({TopoDS::Edge(edge.Current()), face, id});
      brep_->first_edge_of_face.push_back(static_cast<std::uint32_t>(brep_->edges_of_face.size()));
      add_trim(
          face, [this](const TopoDS_Edge& edge) { return number(edge); }, *brep_);
    }
  }

  void add_vertices() {
    first_vertex_ = static_cast<std::uint32_t>(brep_->vertices.size());
    for (int i = 1; i <= vertices_.Extent(); ++i) {
      const TopoDS_Vertex v = TopoDS::Vertex(vertices_(i));
      brep_->vertices.push_back({vector_of(BRep_Tool::Pnt(v)), BRep_Tool::Tolerance(v)});
    }
  }

  void add_edges() {
    for (int i = 1; i <= edges_.Extent(); ++i) {
      const TopoDS_Edge edge = TopoDS::Edge(edges_(i).Oriented(TopAbs_FORWARD));
      const std::vector<Side>& sides = sides_[static_cast<std::size_t>(i)];
      Edge e = plain_edge(edge, *brep_);
      e.vertices = {vertex(TopExp::FirstVertex(edge)), vertex(TopExp::LastVertex(edge))};
      for (std::size_t s = 0; s < std::min<std::size_t>(2, sides.size()); ++s) e.faces[s] = sides[s].id;
      if (BRep_Tool::Degenerated(edge)) e.kind = EdgeKind::smooth;
      if (sides.size() >= 2 && e.curve != no_number) measure_turn({sides[0], sides[1]}, *brep_, e);
      brep_->edges.push_back(e);
    }
  }

 private:
  EdgeId number(const TopoDS_Edge& edge) const {
    return first_edge_ + static_cast<EdgeId>(edges_.FindIndex(edge) - 1);
  }

  void add_side(const Side& side) {
    std::vector<Side>& sides = sides_[static_cast<std::size_t>(edges_.FindIndex(side.edge))];
    const bool seam = !sides.empty() && sides.back().id == side.id;
    if (!seam) brep_->edges_of_face.push_back(number(side.edge));
    sides.push_back(side);
  }

  std::uint32_t vertex(const TopoDS_Vertex& v) const {
    return v.IsNull() ? no_number : first_vertex_ + static_cast<std::uint32_t>(vertices_.FindIndex(v) - 1);
  }

  Brep* brep_;
  EdgeId first_edge_;
  std::uint32_t first_vertex_ = 0;
  TopTools_IndexedMapOfShape edges_, vertices_;
  std::vector<std::vector<Side>> sides_;
};

}  // namespace

void add_topology(const TopoDS_Shape& shape, std::uint32_t body, Brep& brep) {
  Topology topology(shape, brep);
  topology.add_faces(shape, body);
  topology.add_vertices();
  topology.add_edges();
}

}  // namespace gabarit
