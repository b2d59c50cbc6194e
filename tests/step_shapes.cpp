#include "tests/step_shapes.h"

#include <fstream>
#include <numbers>
#include <sstream>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESGraph_Color.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Wire.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Ax1.hxx>
#include <gp_Elips.hxx>
#include <gp_Trsf.hxx>

namespace gabarit::step_shapes {

TopoDS_Shape box(double x, double y, double z) { return BRepPrimAPI_MakeBox(x, y, z).Shape(); }

TopoDS_Shape rounded_box(double x, double y, double z, double radius) {
  const TopoDS_Shape sharp = box(x, y, z);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(sharp, TopAbs_EDGE, edges);
  BRepFilletAPI_MakeFillet fillet(sharp);
  for (int i = 1; i <= edges.Extent(); ++i) fillet.Add(radius, TopoDS::Edge(edges(i)));
  return fillet.Shape();
}

TopoDS_Shape cylinder(double radius, double height) {
  return BRepPrimAPI_MakeCylinder(radius, height).Shape();
}
TopoDS_Shape tube(double outer, double inner, double height) {
  return BRepAlgoAPI_Cut(cylinder(outer, height), cylinder(inner, height)).Shape();
}
TopoDS_Shape cone(double bottom, double height) { return BRepPrimAPI_MakeCone(bottom, 0, height).Shape(); }
TopoDS_Shape sphere(double radius) { return BRepPrimAPI_MakeSphere(radius).Shape(); }
TopoDS_Shape torus(double ring, double tube) { return BRepPrimAPI_MakeTorus(ring, tube).Shape(); }

static TopoDS_Shape extruded(const TopoDS_Edge& outline, double height) {
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(outline).Wire();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire, Standard_True).Shape(), gp_Vec(0, 0, height))
      .Shape();
}

TopoDS_Shape elliptic_cylinder(double a, double b, double height) {
  return extruded(BRepBuilderAPI_MakeEdge(gp_Elips(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), a, b)), height);
}

TopoDS_Shape lobed_cylinder(const std::vector<double>& radii, double height) {
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, static_cast<int>(radii.size()));
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(radii.size());
    points->SetValue(static_cast<int>(i) + 1,
                     gp_Pnt(radii[i] * std::cos(angle), radii[i] * std::sin(angle), 0));
  }
  GeomAPI_Interpolate spline(points, Standard_True, 1e-7);
  spline.Perform();
  return extruded(BRepBuilderAPI_MakeEdge(spline.Curve()), height);
}

TopoDS_Shape as_splines(const TopoDS_Shape& shape) { return BRepBuilderAPI_NurbsConvert(shape).Shape(); }

TopoDS_Shape minus(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Cut(a, b).Shape(); }

TopoDS_Shape prism(const std::vector<std::array<double, 2>>& corners, double height) {
  BRepBuilderAPI_MakePolygon outline;
  for (const auto& [x, y] : corners) outline.Add(gp_Pnt(x, y, 0));
  outline.Close();
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(outline.Wire(), Standard_True).Shape();
  return BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, height)).Shape();
}

TopoDS_Shape moved(const TopoDS_Shape& shape, double x, double y, double z) {
  gp_Trsf move;
  move.SetTranslation(gp_Vec(x, y, z));
  return shape.Moved(move);
}

TopoDS_Shape turned(const TopoDS_Shape& shape, double degrees_about_x) {
  gp_Trsf turn;
  turn.SetRotation(gp::OX(), degrees_about_x * std::numbers::pi / 180);
  return shape.Moved(turn);
}

TopoDS_Shape together(const std::vector<TopoDS_Shape>& shapes) {
  TopoDS_Compound compound;
  BRep_Builder().MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) BRep_Builder().Add(compound, shape);
  return compound;
}

TopoDS_Shape without_a_face(const TopoDS_Shape& shape) {
  TopoDS_Shell shell;
  BRep_Builder().MakeShell(shell);
  TopExp_Explorer it(shape, TopAbs_FACE);
  for (it.Next(); it.More(); it.Next()) BRep_Builder().Add(shell, it.Current());
  return shell;
}

void StepFiles::SetUp() {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPCAFControl_Controller::Init();
  IGESControl_Controller::Init();
}

std::filesystem::path StepFiles::step(const TopoDS_Shape& shape, const std::string& unit) const {
  Interface_Static::SetCVal("write.step.unit", unit.c_str());
  STEPControl_Writer writer;
  writer.Transfer(shape, STEPControl_AsIs);
  const std::filesystem::path file = folder / "part.step";
  writer.Write(file.c_str());
  Interface_Static::SetCVal("write.step.unit", "MM");
  return file;
}

std::filesystem::path StepFiles::one_product(const TopoDS_Shape& shape) const {
  STEPControl_Controller::Init();
  Interface_Static::SetIVal("write.step.assembly", 0);
  const std::filesystem::path file = step(shape);
  Interface_Static::SetIVal("write.step.assembly", 2);
  return file;
}

std::filesystem::path StepFiles::iges(const TopoDS_Shape& shape, const std::string& unit) const {
  IGESControl_Writer writer(unit.c_str(), 1);
  writer.AddShape(shape);
  writer.ComputeModel();
  const std::filesystem::path file = folder / "part.igs";
  writer.Write(file.c_str());
  return file;
}

std::filesystem::path StepFiles::painted_iges(const TopoDS_Shape& shape) const {
  IGESControl_Writer writer("MM", 0);
  writer.AddShape(shape);
  const Handle(IGESGraph_Color) orange = new IGESGraph_Color();
  orange->Init(100, 50, 0, new TCollection_HAsciiString("orange"));
  writer.AddEntity(orange);
  const Handle(IGESData_IGESModel) model = writer.Model();
  bool by_number = false;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(IGESData_IGESEntity) entity = model->Entity(i);
    if (entity->TypeNumber() != 144) continue;  // trimmed surfaces
    by_number = !by_number;
    by_number ? entity->InitColor(nullptr, 2) : entity->InitColor(orange);
  }
  writer.ComputeModel();
  const std::filesystem::path file = folder / "painted.igs";
  writer.Write(file.c_str());
  return file;
}

namespace {

struct Document {
  Document() {
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
    shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  }

  TDF_Label assembly(const char* name, const std::vector<NamedShape>& parts) const {
    const TDF_Label root = shapes->NewShape();
    TDataStd_Name::Set(root, name);
    for (const NamedShape& part : parts) {
      const TDF_Label product = shapes->AddShape(part.shape.Located(TopLoc_Location()), Standard_False);
      TDataStd_Name::Set(product, TCollection_ExtendedString(part.name.c_str(), Standard_True));
      shapes->AddComponent(root, product, part.shape.Location());
    }
    return root;
  }

  std::filesystem::path written(const std::filesystem::path& file) const {
    shapes->UpdateAssemblies();
    STEPCAFControl_Writer writer;
    writer.Transfer(document, STEPControl_AsIs);
    writer.Write(file.c_str());
    return file;
  }

  Handle(TDocStd_Document) document;
  Handle(XCAFDoc_ShapeTool) shapes;
};

}  // namespace

std::filesystem::path StepFiles::assembly(const std::vector<NamedShape>& parts) const {
  const Document document;
  document.assembly("assembly", parts);
  return document.written(folder / "assembly.stp");
}

std::filesystem::path StepFiles::nested(const std::vector<NamedShape>& parts, const gp_Trsf& one,
                                        const gp_Trsf& other) const {
  const Document document;
  const TDF_Label inner = document.assembly("inner", parts);
  const TDF_Label outer = document.assembly("outer", {});
  document.shapes->AddComponent(outer, inner, one);
  document.shapes->AddComponent(outer, inner, other);
  return document.written(folder / "nested.stp");
}

std::filesystem::path StepFiles::text(const std::string& name, const std::string& content) const {
  const std::filesystem::path file = folder / name;
  std::ofstream(file, std::ios::binary) << content;
  return file;
}

Model loaded(const std::filesystem::path& file, const LoadOptions& options) {
  Result<Model> model = load(file, options);
  if (!model) {
    ADD_FAILURE() << to_string(model.error().front());
    return {};
  }
  return std::move(*model);
}

double volume(const Model& model) {
  double six = 0;
  for (FacetId f = 0; f < model.mesh.facet_count(); ++f) {
    const auto [a, b, c] = model.mesh.corners(f);
    six += dot(a, cross(b, c));
  }
  return six / 6;
}

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

std::string replaced(std::string content, const std::string& what, const std::vector<std::string>& by) {
  std::size_t at = 0;
  for (const std::string& text : by) {
    at = content.find(what, at);
    if (at == std::string::npos) {
      ADD_FAILURE() << "no " << what;
      return content;
    }
    content.replace(at, what.size(), text);
    at += text.size();
  }
  return content;
}

}  // namespace gabarit::step_shapes
