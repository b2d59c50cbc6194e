#include "model/load_step.h"

#include <algorithm>

#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <fmt/format.h>

#include "model/cad_unit.h"
#include "model/occt_model.h"
#include "model/step_header.h"
#include "model/text_encoding.h"

namespace gabarit {
namespace {

constexpr double read_share = 0.1, transfer_share = 0.5;  // of the time, until there

// The unit of most of the file's shapes; OpenCASCADE itself minds each shape's own.
void set_unit(STEPControl_Reader& reader, std::string_view bytes, const std::string& file,
              const LoadOptions& options, Model& model) {
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  std::vector<std::string> names;
  for (const TCollection_AsciiString& length : lengths) {
    if (!length.IsEmpty()) names.emplace_back(length.ToCString());
  }
  // OpenCASCADE converts by such units but does not name all of them.
  if (names.empty() && !lengths.IsEmpty()) names = step_conversion_units(bytes);
  set_declared_unit(names, file, options, model);
}

// Parts that would be missing without a word.
Diagnostic facets_unread(const std::string& file, std::size_t count) {
  return {.file = file,
          .message = fmt::format("holds {} bodies or shells as facets without exact surfaces (AP242 "
                                 "tessellation), which OpenCASCADE 7.6 does not read: nothing is measured "
                                 "there; export them with exact surfaces, or as STL",
                                 count)};
}

Diagnostics transfer(STEPControl_Reader& reader, const std::filesystem::path& file, std::string_view bytes,
                     const LoadOptions& options, const Handle(OcctProgress) & progress, Model& model) {
  reader.TransferRoots(progress->start(read_share, transfer_share));
  if (progress->time_is_over()) return out_of_time(file.string(), options);
  set_unit(reader, bytes, file.string(), options, model);
  OcctNames names = step_names(reader);
  std::vector<OcctPart> found = parts(reader, names, valid_utf8(file.stem().string()));
  if (const std::size_t count = step_bodies_of_facets(bytes); count > 0) {
    Diagnostic unread = facets_unread(file.string(), count);
    if (found.empty()) return {std::move(unread)};
    unread.level = Diagnostic::Level::warning;
    model.warnings.push_back(std::move(unread));
  }
  return fill_model(std::move(found), std::move(names), file.string(), options, progress, model);
}

Diagnostics read(const std::filesystem::path& file, std::string_view bytes, const LoadOptions& options,
                 Model& model) {
  STEPControl_Controller::Init();
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  const Handle(OcctProgress) progress = new OcctProgress(options);
  STEPControl_Reader reader;
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
    return {{.file = file.string(), .message = "is no STEP file that OpenCASCADE can read; export it again"}};
  return transfer(reader, file, bytes, options, progress, model);
}

}  // namespace

bool step_can_be_read() { return true; }

Diagnostics load_step(const std::filesystem::path& file, std::string_view bytes, const LoadOptions& options,
                      Model& model) {
  if (Diagnostics errors = step_errors(bytes, file.string()); !errors.empty()) return errors;
  model.format = step_format(bytes);
  return with_occt(file.string(), [&] { return read(file, bytes, options, model); });
}

}  // namespace gabarit
