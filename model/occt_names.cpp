#include "model/occt_names.h"

#include <IGESData_IGESEntity.hxx>
#include <Interface_InterfaceModel.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "model/occt_colours.h"
#include "model/text_encoding.h"

namespace gabarit {
namespace {

std::string text_of(const Handle(TCollection_HAsciiString) & text) {
  return text.IsNull() ? std::string() : valid_utf8(text->ToCString());
}

// A product without a name has at least an identifier.
std::string product_name(const StepBasic_ProductDefinition& definition) {
  const Handle(StepBasic_ProductDefinitionFormation) formation = definition.Formation();
  if (formation.IsNull() || formation->OfProduct().IsNull()) return {};
  const std::string name = text_of(formation->OfProduct()->Name());
  return name.empty() ? text_of(formation->OfProduct()->Id()) : name;
}

// Some programs write it where they have no name.
bool is_name(const std::string& text) { return !text.empty() && text != "NONE"; }

template <class Visit>
void for_each_result(const XSControl_Reader& reader, const Visit& visit) {
  const Handle(Interface_InterfaceModel) model = reader.Model();
  const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  if (model.IsNull() || process.IsNull()) return;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = model->Value(i);
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
    if (!shape.IsNull()) visit(entity, shape);
  }
}

}  // namespace

void OcctNames::hand_on(const TopoDS_Shape& before,
                        const std::function<TopoDS_Shape(const TopoDS_Shape&)>& successor) {
  for (const TopAbs_ShapeEnum type : {TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE}) {
    for (TopExp_Explorer from(before, type); from.More(); from.Next()) {
      const TopoDS_Shape after = successor(from.Current());
      if (after.IsNull()) continue;
      const auto name = items.find(key(from.Current()));
      const auto colour = colours.find(key(from.Current()));
      for (TopExp_Explorer to(after, type); to.More(); to.Next()) {
        if (name != items.end()) items.emplace(key(to.Current()), name->second);
        if (colour != colours.end()) colours.emplace(key(to.Current()), colour->second);
      }
    }
  }
}

void OcctNames::add_labels(const TopoDS_Shape& shape, std::vector<FaceLabel>& labels) const {
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    FaceLabel& label = labels.emplace_back();
    const auto name = items.find(key(it.Current()));
    const auto colour = colours.find(key(it.Current()));
    if (name != items.end()) label.name = name->second;
    if (colour != colours.end()) label.colour = colour->second;
  }
}

OcctNames step_names(const XSControl_Reader& reader) {
  OcctNames names;
  for_each_result(reader, [&](const Handle(Standard_Transient) & entity, const TopoDS_Shape& shape) {
    if (const auto product = Handle(StepBasic_ProductDefinition)::DownCast(entity); !product.IsNull()) {
      names.products.emplace(OcctNames::key(shape), product_name(*product));
    } else if (const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity); !item.IsNull()) {
      const std::string name = text_of(item->Name());
      if (is_name(name)) names.items.emplace(OcctNames::key(shape), name);
    }
  });
  names.colours = step_colours(reader);
  return names;
}

OcctNames iges_names(const XSControl_Reader& reader) {
  OcctNames names;
  for_each_result(reader, [&](const Handle(Standard_Transient) & entity, const TopoDS_Shape& shape) {
    const auto named = Handle(IGESData_IGESEntity)::DownCast(entity);
    if (!named.IsNull() && named->HasName())
      names.items.emplace(OcctNames::key(shape), text_of(named->NameValue()));
  });
  names.colours = iges_colours(reader);
  return names;
}

}  // namespace gabarit
