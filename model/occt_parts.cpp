#include "model/occt_parts.h"

#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include "model/text_encoding.h"

namespace gabarit {
namespace {

std::string text_of(const TCollection_ExtendedString& text) {
  std::string bytes(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
  Standard_PCharacter to = bytes.data();
  bytes.resize(static_cast<std::size_t>(text.ToUTF8CString(to)));
  return valid_utf8(bytes);
}

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  return label.FindAttribute(TDataStd_Name::GetID(), name) ? text_of(name->Get()) : std::string();
}

bool rigid(const gp_Trsf& placement) {
  return !placement.IsNegative() && std::abs(placement.ScaleFactor() - 1) < 1e-12;
}

// A scaling or mirroring placement goes into the geometry itself.
TopoDS_Shape placed(const TopoDS_Shape& shape, const TopLoc_Location& at) {
  if (at.IsIdentity()) return shape;
  if (rigid(at.Transformation())) return shape.Moved(at);
  return BRepBuilderAPI_Transform(shape, at.Transformation(), Standard_True).Shape();
}

class Gathering {
 public:
  explicit Gathering(const std::string& fallback) : fallback_(fallback) {}

  void add(const TDF_Label& label, const TopLoc_Location& at, const std::string& outer_name) {
    const std::string own = name_of(label);
    const std::string& name = own.empty() ? outer_name : own;
    TDF_Label referred;
    if (XCAFDoc_ShapeTool::GetReferredShape(label, referred))
      return add(referred, at * XCAFDoc_ShapeTool::GetLocation(label), name);
    TDF_LabelSequence components;
    if (!XCAFDoc_ShapeTool::GetComponents(label, components)) return add_shape(label, at, name);
    for (const TDF_Label& component : components) add(component, at, name);
  }

  std::vector<OcctPart> parts;

 private:
  void add_shape(const TDF_Label& label, const TopLoc_Location& at, const std::string& name) {
    const TopoDS_Shape shape = placed(XCAFDoc_ShapeTool::GetShape(label), at);
    const std::size_t first = parts.size();
    for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next()) add_part(name, it.Current(), true);
    for (TopExp_Explorer it(shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next())
      add_shell(name, it.Current());
    add_loose_faces(name, shape);
    if (parts.size() > first + 1) name_solids(label, at, first);
  }

  void add_part(const std::string& name, const TopoDS_Shape& shape, bool solid) {
    parts.push_back({name.empty() ? fallback_ : name, shape, solid});
  }

  void add_shell(const std::string& name, const TopoDS_Shape& shell) {
    if (!BRep_Tool::IsClosed(shell)) return add_part(name, shell, false);
    TopoDS_Solid solid;
    BRep_Builder().MakeSolid(solid);
    BRep_Builder().Add(solid, shell);
    add_part(name, solid, true);
  }

  void add_loose_faces(const std::string& name, const TopoDS_Shape& shape) {
    TopExp_Explorer it(shape, TopAbs_FACE, TopAbs_SHELL);
    if (!it.More()) return;
    TopoDS_Compound compound;
    BRep_Builder().MakeCompound(compound);
    for (; it.More(); it.Next()) BRep_Builder().Add(compound, it.Current());
    add_part(name, compound, false);
  }

  // Names that the file gives to single solids of one product are names of sub-shapes.
  void name_solids(const TDF_Label& label, const TopLoc_Location& at, std::size_t first) {
    TDF_LabelSequence labels;
    XCAFDoc_ShapeTool::GetSubShapes(label, labels);
    for (const TDF_Label& sub : labels) {
      const std::string name = name_of(sub);
      const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(sub).Moved(at);
      for (std::size_t i = first; i < parts.size() && !name.empty(); ++i) {
        if (parts[i].shape.IsPartner(shape) && parts[i].name != name) parts[i].name += "/" + name;
      }
    }
  }

  std::string fallback_;
};

}  // namespace

Handle(TDocStd_Document) new_document() {
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  return document;
}

std::vector<OcctPart> parts(const Handle(TDocStd_Document) & document, const std::string& fallback) {
  TDF_LabelSequence roots;
  XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(roots);
  Gathering gathering(fallback);
  for (const TDF_Label& root : roots) gathering.add(root, TopLoc_Location(), "");
  return std::move(gathering.parts);
}

}  // namespace gabarit
