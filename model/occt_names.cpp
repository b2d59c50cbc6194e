#include "model/occt_names.h"

#include <IGESData_IGESEntity.hxx>
#include <Interface_InterfaceModel.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

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

OcctNames step_names(const XSControl_Reader& reader) {
  OcctNames names;
  for_each_result(reader, [&](const Handle(Standard_Transient) & entity, const TopoDS_Shape& shape) {
    if (const auto product = Handle(StepBasic_ProductDefinition)::DownCast(entity); !product.IsNull()) {
      names.products.emplace(OcctNames::key(shape), product_name(*product));
    } else if (const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity); !item.IsNull()) {
      const std::string name = text_of(item->Name());
      if (!name.empty()) names.items.emplace(OcctNames::key(shape), name);
    }
  });
  return names;
}

OcctNames iges_names(const XSControl_Reader& reader) {
  OcctNames names;
  for_each_result(reader, [&](const Handle(Standard_Transient) & entity, const TopoDS_Shape& shape) {
    const auto named = Handle(IGESData_IGESEntity)::DownCast(entity);
    if (!named.IsNull() && named->HasName())
      names.items.emplace(OcctNames::key(shape), text_of(named->NameValue()));
  });
  return names;
}

}  // namespace gabarit
