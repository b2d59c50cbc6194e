#include "model/occt_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include <IGESData_IGESEntity.hxx>
#include <IGESGraph_Color.hxx>
#include <Interface_InterfaceModel.hxx>
#include <STEPConstruct_Styles.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_ColourRgb.hxx>
#include <StepVisual_ContextDependentOverRidingStyledItem.hxx>
#include <StepVisual_OverRidingStyledItem.hxx>
#include <StepVisual_PreDefinedColour.hxx>
#include <StepVisual_PreDefinedItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "model/occt_names.h"

namespace gabarit {
namespace {

std::uint8_t byte_of(double share) {
  return std::isfinite(share) ? static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0))) : 0;
}
Colour colour_of(double red, double green, double blue) {
  return {byte_of(red), byte_of(green), byte_of(blue)};
}

struct NamedColour {
  std::string_view name;
  Colour colour;
};

// ISO 10303-46's predefined colours.
std::optional<Colour> colour_named(std::string_view name) {
  static constexpr std::array<NamedColour, 8> known{{{"red", {255, 0, 0}},
                                                     {"green", {0, 255, 0}},
                                                     {"blue", {0, 0, 255}},
                                                     {"yellow", {255, 255, 0}},
                                                     {"magenta", {255, 0, 255}},
                                                     {"cyan", {0, 255, 255}},
                                                     {"black", {0, 0, 0}},
                                                     {"white", {255, 255, 255}}}};
  for (const NamedColour& c : known) {
    if (c.name == name) return c.colour;
  }
  return {};
}

// What a shape is painted with; paint of a lower rank stays.
struct Paint {
  TopoDS_Shape shape;
  Colour colour;
  int rank = 0;
};

// Faces before shells before solids before compounds.
int rank_of(const TopoDS_Shape& shape) { return 2 * (TopAbs_FACE - shape.ShapeType()); }

std::map<const void*, Colour> painted(std::vector<Paint> paints) {
  std::stable_sort(paints.begin(), paints.end(),
                   [](const Paint& a, const Paint& b) { return a.rank < b.rank; });
  std::map<const void*, Colour> colours;
  for (const Paint& paint : paints) {
    for (TopExp_Explorer it(paint.shape, TopAbs_FACE); it.More(); it.Next())
      colours.emplace(OcctNames::key(it.Current()), paint.colour);
  }
  return colours;
}

std::optional<Colour> colour_of(const Handle(StepVisual_Colour) & colour) {
  if (const auto rgb = Handle(StepVisual_ColourRgb)::DownCast(colour); !rgb.IsNull())
    return colour_of(rgb->Red(), rgb->Green(), rgb->Blue());
  const auto named = Handle(StepVisual_PreDefinedColour)::DownCast(colour);
  if (named.IsNull() || named->GetPreDefinedItem().IsNull()) return {};
  const Handle(TCollection_HAsciiString) name = named->GetPreDefinedItem()->Name();
  return name.IsNull() ? std::nullopt : colour_named(name->ToCString());
}

std::optional<Colour> colour_of(const STEPConstruct_Styles& styles,
                                const Handle(StepVisual_StyledItem) & item) {
  Handle(StepVisual_Colour) surface, boundary, curve, rendering;
  double transparency = 0;
  Standard_Boolean unused = Standard_False;
  if (!styles.GetColors(item, surface, boundary, curve, rendering, transparency, unused)) return {};
  return colour_of(surface.IsNull() ? rendering : surface);
}

// Some programs style a representation as a whole.
std::vector<TopoDS_Shape> shapes_of(const StepVisual_StyledItem& styled,
                                    const Handle(Transfer_TransientProcess) & process) {
  std::vector<TopoDS_Shape> shapes;
  const auto add = [&](const Handle(StepRepr_RepresentationItem) & item) {
    const TopoDS_Shape shape = item.IsNull() ? TopoDS_Shape() : TransferBRep::ShapeResult(process, item);
    if (!shape.IsNull()) shapes.push_back(shape);
  };
  add(styled.Item());
  const auto whole = Handle(StepRepr_Representation)::DownCast(styled.ItemAP242().Value());
  if (whole.IsNull() || whole->Items().IsNull()) return shapes;
  for (int i = 1; i <= whole->NbItems(); ++i) add(whole->ItemsValue(i));
  return shapes;
}

bool of_one_instance(const Handle(Standard_Transient) & style) {
  return !Handle(StepVisual_ContextDependentOverRidingStyledItem)::DownCast(style).IsNull();
}

std::optional<Colour> colour_numbered(int number) {
  static constexpr std::array<Colour, 9> known{{{},
                                                {0, 0, 0},
                                                {255, 0, 0},
                                                {0, 255, 0},
                                                {0, 0, 255},
                                                {255, 255, 0},
                                                {255, 0, 255},
                                                {0, 255, 255},
                                                {255, 255, 255}}};
  if (number < 1 || number > 8) return {};
  return known[static_cast<std::size_t>(number)];
}

std::optional<Colour> colour_of(const IGESData_IGESEntity& entity) {
  if (entity.DefColor() == IGESData_DefValue) return colour_numbered(entity.RankColor());
  const auto defined = Handle(IGESGraph_Color)::DownCast(entity.Color());
  if (defined.IsNull()) return {};
  double red = 0, green = 0, blue = 0;  // per cent
  defined->RGBIntensity(red, green, blue);
  return colour_of(red / 100, green / 100, blue / 100);
}

// Calls visit(entity, transferred) for all entities of the file.
template <class Visit>
void for_each_entity(const XSControl_Reader& reader, const Visit& visit) {
  const Handle(Interface_InterfaceModel) model = reader.Model();
  const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  if (model.IsNull() || process.IsNull()) return;
  for (int i = 1; i <= model->NbEntities(); ++i) visit(model->Value(i), process);
}

}  // namespace

std::map<const void*, Colour> step_colours(const XSControl_Reader& reader) {
  const STEPConstruct_Styles styles;
  std::vector<Paint> paints;
  for_each_entity(reader, [&](const Handle(Standard_Transient) & entity, const auto& process) {
    const auto styled = Handle(StepVisual_StyledItem)::DownCast(entity);
    if (styled.IsNull() || of_one_instance(entity)) return;
    const std::optional<Colour> colour = colour_of(styles, styled);
    if (!colour) return;
    const bool plain = Handle(StepVisual_OverRidingStyledItem)::DownCast(entity).IsNull();
    for (const TopoDS_Shape& shape : shapes_of(*styled, process))
      paints.push_back({shape, *colour, rank_of(shape) + (plain ? 1 : 0)});
  });
  return painted(std::move(paints));
}

std::map<const void*, Colour> iges_colours(const XSControl_Reader& reader) {
  std::vector<Paint> paints;
  for_each_entity(reader, [&](const Handle(Standard_Transient) & entity, const auto& process) {
    const auto item = Handle(IGESData_IGESEntity)::DownCast(entity);
    if (item.IsNull()) return;
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
    if (shape.IsNull()) return;
    if (const auto colour = colour_of(*item)) paints.push_back({shape, *colour, rank_of(shape)});
  });
  return painted(std::move(paints));
}

}  // namespace gabarit
