#include <array>

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>
#include <XSControl_WorkSession.hxx>
#include <fmt/format.h>

#include "model/cad_unit.h"
#include "model/load_step.h"
#include "model/occt_model.h"
#include "model/text_encoding.h"

namespace gabarit {
namespace {

constexpr double sewing_tolerance = 0.01;  // mm: what IGES writers leave between neighbouring faces

// Every record is 80 characters long, the 73rd names its section; the last one is the terminate section.
Diagnostics iges_errors(std::string_view bytes, const std::string& file) {
  const std::string_view end = bytes.substr(bytes.size() - std::min<std::size_t>(bytes.size(), 4096));
  const std::size_t last = end.find_last_not_of("\r\n \t\x1A");
  const std::size_t begin = last == std::string_view::npos ? last : end.find_last_of("\r\n", last);
  const std::string_view record = end.substr(begin == std::string_view::npos ? 0 : begin + 1);
  if (record.size() >= 73 && record[72] == 'T') return {};
  return {
      {.file = file,
       .message = "is no IGES file, or is cut off: its last line is no terminate record (T in column 73)"}};
}

// Faces that were written one by one become shells, closed ones solids.
std::vector<OcctPart> sewn(const std::vector<OcctPart>& found, OcctNames& names) {
  std::vector<OcctPart> result;
  BRepBuilderAPI_Sewing sewing(sewing_tolerance);
  std::string name;
  for (const OcctPart& part : found) {
    if (part.solid) {
      result.push_back(part);
      continue;
    }
    sewing.Add(part.shape);
    if (name.empty()) name = part.name;
  }
  if (name.empty()) return result;
  sewing.Perform();
  const TopoDS_Shape whole = sewing.SewedShape();
  for (const OcctPart& part : found) {
    if (!part.solid)
      names.hand_on(part.shape, [&](const TopoDS_Shape& face) { return sewing.ModifiedSubShape(face); });
  }
  TopoDS_Compound loose;
  BRep_Builder().MakeCompound(loose);
  bool any_loose = false;
  for (TopExp_Explorer it(whole, TopAbs_SHELL); it.More(); it.Next()) {
    const bool closed = BRep_Tool::IsClosed(it.Current());
    TopoDS_Solid solid;
    BRep_Builder().MakeSolid(solid);
    BRep_Builder().Add(solid, it.Current());
    result.push_back({name, closed ? TopoDS_Shape(solid) : it.Current(), closed});
  }
  for (TopExp_Explorer it(whole, TopAbs_FACE, TopAbs_SHELL); it.More(); it.Next(), any_loose = true)
    BRep_Builder().Add(loose, it.Current());
  if (any_loose) result.push_back({name, loose, false});
  return result;
}

std::string unit_of(const IGESControl_Reader& reader) {
  const auto content = Handle(IGESData_IGESModel)::DownCast(reader.WS()->Model());
  if (content.IsNull()) return "";
  const Handle(TCollection_HAsciiString) unit = content->GlobalSection().UnitName();
  return unit.IsNull() ? "" : unit->ToCString();
}

Diagnostics read(const std::filesystem::path& file, const LoadOptions& options, Model& model) {
  IGESControl_Controller::Init();
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  const Handle(OcctProgress) progress = new OcctProgress(options);
  IGESControl_Reader reader;
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
    return {{.file = file.string(), .message = "is no IGES file that OpenCASCADE can read; export it again"}};
  reader.TransferRoots(progress->start(0.1, 0.5));
  if (progress->time_is_over()) return out_of_time(file.string(), options);
  OcctNames names = iges_names(reader);
  std::vector<OcctPart> found = sewn(parts(reader, names, valid_utf8(file.stem().string())), names);
  const std::string unit = unit_of(reader);
  set_declared_unit(unit.empty() ? std::vector<std::string>{} : std::vector{unit}, file.string(), options,
                    model);
  return fill_model(std::move(found), std::move(names), file.string(), options, progress, model);
}

}  // namespace

Diagnostics load_iges(const std::filesystem::path& file, std::string_view bytes, const LoadOptions& options,
                      Model& model) {
  if (Diagnostics errors = iges_errors(bytes, file.string()); !errors.empty()) return errors;
  model.format = "IGES";
  return with_occt(file.string(), [&] { return read(file, options, model); });
}

}  // namespace gabarit
