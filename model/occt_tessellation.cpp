#include "model/occt_tessellation.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "model/occt_geometry.h"

namespace gabarit {
namespace {

constexpr VertexId none = 0xFFFFFFFFU;

class Stitching {
 public:
  Stitching(const TopoDS_Shape& shape, TriangleMesh& mesh) : mesh_(&mesh) {
    TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
    TopExp::MapShapes(shape, TopAbs_VERTEX, corners_);
    along_edge_.resize(static_cast<std::size_t>(edges_.Extent()) + 1);
    at_corner_.resize(static_cast<std::size_t>(corners_.Extent()) + 1, none);
  }

  // The mesh vertices of the nodes of one face's triangulation, counted from 0.
  std::vector<VertexId> vertices_of(const TopoDS_Face& face, const Handle(Poly_Triangulation) & triangles,
                                    const TopLoc_Location& at) {
    std::vector<VertexId> numbers(static_cast<std::size_t>(triangles->NbNodes()), none);
    const gp_Trsf placement = at.Transformation();
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
      stitch(TopoDS::Edge(it.Current()), triangles, at, placement, numbers);
    for (int i = 0; i < triangles->NbNodes(); ++i) {
      VertexId& number = numbers[static_cast<std::size_t>(i)];
      if (number == none) number = new_vertex(triangles->Node(i + 1).Transformed(placement));
    }
    return numbers;
  }

  std::uint64_t unmatched = 0;

 private:
  VertexId new_vertex(const gp_Pnt& p) {
    mesh_->vertices.push_back(vector_of(p));
    return static_cast<VertexId>(mesh_->vertices.size() - 1);
  }

  VertexId corner(const TopoDS_Vertex& v) {
    VertexId& number = at_corner_[static_cast<std::size_t>(corners_.FindIndex(v))];
    if (number == none) number = new_vertex(BRep_Tool::Pnt(v));
    return number;
  }

  void stitch(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & triangles,
              const TopLoc_Location& at, const gp_Trsf& placement, std::vector<VertexId>& numbers) {
    const Handle(Poly_PolygonOnTriangulation) polygon =
        BRep_Tool::PolygonOnTriangulation(edge, triangles, at);
    if (polygon.IsNull()) return;
    const int n = polygon->NbNodes();
    std::vector<VertexId>& along = along_edge_[static_cast<std::size_t>(edges_.FindIndex(edge))];
    if (along.empty()) along = new_line(edge, *polygon, *triangles, placement);
    if (along.size() != static_cast<std::size_t>(n)) return ++unmatched, void();
    for (int i = 0; i < n; ++i)
      numbers[static_cast<std::size_t>(polygon->Node(i + 1) - 1)] = along[static_cast<std::size_t>(i)];
  }

  std::vector<VertexId> new_line(const TopoDS_Edge& edge, const Poly_PolygonOnTriangulation& polygon,
                                 const Poly_Triangulation& triangles, const gp_Trsf& placement) {
    const auto n = static_cast<std::size_t>(polygon.NbNodes());
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex first = TopExp::FirstVertex(forward), last = TopExp::LastVertex(forward);
    std::vector<VertexId> line(n, none);
    if (BRep_Tool::Degenerated(edge) && !first.IsNull()) return line.assign(n, corner(first)), line;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == 0 && !first.IsNull())
        line[i] = corner(first);
      else if (i + 1 == n && !last.IsNull())
        line[i] = corner(last);
      else
        line[i] = new_vertex(triangles.Node(polygon.Node(static_cast<int>(i) + 1)).Transformed(placement));
    }
    return line;
  }

  TriangleMesh* mesh_;
  TopTools_IndexedMapOfShape edges_, corners_;
  std::vector<std::vector<VertexId>> along_edge_;
  std::vector<VertexId> at_corner_;
};

Parameters parameters(const Poly_Triangulation& triangles, int node) {
  if (!triangles.HasUVNodes()) return {};
  const gp_Pnt2d uv = triangles.UVNode(node);
  return {uv.X(), uv.Y()};
}

void add_face(const TopoDS_Face& face, const Poly_Triangulation& triangles,
              const std::vector<VertexId>& numbers, FaceId id, std::uint32_t body, TriangleMesh& mesh,
              std::vector<FacetOrigin>& origins) {
  const bool reversed = face.Orientation() == TopAbs_REVERSED;
  for (int t = 1; t <= triangles.NbTriangles(); ++t) {
    std::array<int, 3> n{};
    triangles.Triangle(t).Get(n[0], n[1], n[2]);
    if (reversed) std::swap(n[1], n[2]);
    std::array<VertexId, 3> corners{};
    FacetOrigin origin{.face = id, .corners = {}};
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = numbers[static_cast<std::size_t>(n[i] - 1)];
      origin.corners[i] = parameters(triangles, n[i]);
    }
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    mesh.facets.push_back(corners);
    mesh.body.push_back(body);
    origins.push_back(origin);
  }
}

}  // namespace

void triangulate(const TopoDS_Shape& shape, const TessellationOptions& options,
                 const Message_ProgressRange& progress) {
  IMeshTools_Parameters parameters;
  parameters.Deflection = options.sag;
  parameters.Angle = options.angle;
  // On this thread only: a crash on another one could not be caught.
  parameters.InParallel = Standard_False;
  BRepMesh_IncrementalMesh(shape, parameters, progress);
}

Tessellation append_facets(const TopoDS_Shape& shape, std::uint32_t body, FaceId first_face,
                           TriangleMesh& mesh, std::vector<FacetOrigin>& origins) {
  Tessellation result;
  Stitching stitching(shape, mesh);
  FaceId id = first_face;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next(), ++id) {
    const TopoDS_Face face = TopoDS::Face(it.Current());
    TopLoc_Location at;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, at);
    if (triangles.IsNull() || triangles->NbTriangles() == 0) {
      ++result.faces_without;
      continue;
    }
    add_face(face, *triangles, stitching.vertices_of(face, triangles, at), id, body, mesh, origins);
  }
  result.edges_unmatched = stitching.unmatched;
  return result;
}

}  // namespace gabarit
