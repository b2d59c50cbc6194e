#include "model/occt_parts.h"

#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Solid.hxx>

namespace gabarit {
namespace {

bool rigid(const gp_Trsf& placement) {
  return !placement.IsNegative() && std::abs(placement.ScaleFactor() - 1) < 1e-12;
}

// A scaling or mirroring placement goes into the geometry itself.
TopoDS_Shape with_rigid_placement(const TopoDS_Shape& shape, OcctNames& names) {
  const TopLoc_Location& at = shape.Location();
  if (at.IsIdentity() || rigid(at.Transformation())) return shape;
  const TopoDS_Shape here = shape.Located(TopLoc_Location());
  BRepBuilderAPI_Transform transform(here, at.Transformation(), Standard_True);
  names.hand_on(here, [&](const TopoDS_Shape& part) { return transform.ModifiedShape(part); });
  return transform.Shape();
}

class Gathering {
 public:
  Gathering(OcctNames& names, const std::string& fallback) : names_(&names), fallback_(fallback) {}

  // A compound that holds products is an assembly; what lies loose in one is a part of the assembly's own.
  void add(const TopoDS_Shape& shape, const std::string& outer_name) {
    const std::string& name = name_of(shape, outer_name);
    if (!holds_products(shape)) return add_shape(shape, name);
    TopoDS_Compound loose;
    BRep_Builder().MakeCompound(loose);
    bool any_loose = false;
    for (TopoDS_Iterator it(shape); it.More(); it.Next()) {
      if (is_product(it.Value()) || holds_products(it.Value())) {
        add(it.Value(), name);
      } else {
        BRep_Builder().Add(loose, it.Value());
        any_loose = true;
      }
    }
    if (any_loose) add_shape(loose, name);
  }

  std::vector<OcctPart> parts;

 private:
  const std::string& name_of(const TopoDS_Shape& shape, const std::string& outer_name) const {
    for (const auto* known : {&names_->products, &names_->items}) {
      const auto found = known->find(OcctNames::key(shape));
      if (found != known->end() && !found->second.empty()) return found->second;
    }
    return outer_name;
  }

  bool is_product(const TopoDS_Shape& shape) const {
    return names_->products.count(OcctNames::key(shape)) > 0;
  }

  bool holds_products(const TopoDS_Shape& shape) const {
    if (shape.ShapeType() != TopAbs_COMPOUND) return false;
    for (TopoDS_Iterator it(shape); it.More(); it.Next()) {
      if (is_product(it.Value()) || holds_products(it.Value())) return true;
    }
    return false;
  }

  void add_shape(const TopoDS_Shape& placed, const std::string& name) {
    const TopoDS_Shape shape = with_rigid_placement(placed, *names_);
    const std::size_t first = parts.size();
    for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next()) add_part(name, it.Current(), true);
    for (TopExp_Explorer it(shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next())
      add_shell(name, it.Current());
    add_loose_faces(name, shape);
    if (parts.size() > first + 1) name_solids(first);
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

  void name_solids(std::size_t first) {
    for (std::size_t i = first; i < parts.size(); ++i) {
      const auto found = names_->items.find(OcctNames::key(parts[i].shape));
      if (found != names_->items.end() && found->second != parts[i].name)
        parts[i].name += "/" + found->second;
    }
  }

  OcctNames* names_;
  std::string fallback_;
};

}  // namespace

std::vector<OcctPart> parts(const XSControl_Reader& reader, OcctNames& names, const std::string& fallback) {
  Gathering gathering(names, fallback);
  for (int i = 1; i <= reader.NbShapes(); ++i) gathering.add(reader.Shape(i), "");
  return std::move(gathering.parts);
}

}  // namespace gabarit
