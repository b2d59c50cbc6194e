#include "model/load.h"

#include <algorithm>
#include <cctype>
#include <future>

#include <fmt/format.h>

#include "model/load_obj.h"
#include "model/load_off.h"
#include "model/load_ply.h"
#include "model/load_step.h"
#include "model/load_stl.h"
#include "model/mapped_file.h"
#include "model/sha256.h"
#include "model/text_encoding.h"

namespace gabarit {
namespace {

std::string lower_ending(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

// What the bytes are, whatever the name says; empty when they do not tell.
std::string ending_of_content(std::string_view bytes) {
  if (has_announced_size(bytes)) return ".stl";
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return ".ply";
  if (bytes.starts_with("OFF") || bytes.starts_with("COFF") || bytes.starts_with("NOFF")) return ".off";
  if (bytes.starts_with("glTF")) return ".glb";
  if (bytes.starts_with("PK\x03\x04")) return ".zip";
  if (bytes.starts_with("\x1F\x8B")) return ".gz";
  if (bytes.starts_with("ISO-10303-21")) return ".step";
  return begins_as_ascii_stl(bytes.substr(0, 4096)) ? ".stl" : "";
}

bool is_step(const std::string& ending) { return ending == ".step" || ending == ".stp" || ending == ".p21"; }
bool is_iges(const std::string& ending) { return ending == ".iges" || ending == ".igs"; }
bool can_be_read(const std::string& ending) {
  return ending == ".stl" || ending == ".obj" || ending == ".ply" || ending == ".off" || is_step(ending) ||
         is_iges(ending);
}

// The ending to read by. A name that says something else than the content is worth a warning.
std::string ending_to_read(const std::filesystem::path& file, std::string_view bytes, Model& model) {
  std::string named = lower_ending(file);
  std::string found = ending_of_content(bytes);
  if (found == ".step" && is_step(named)) return named;
  if (found.empty() || found == named || (!can_be_read(named) && !named.empty())) return named;
  model.warnings.push_back(
      {.level = Diagnostic::Level::warning,
       .file = file.string(),
       .message = fmt::format("the content is that of a {} file, whatever the name says", found)});
  return found;
}

Diagnostics unreadable(const std::string& name, const std::string& ending) {
  const std::string what = ending.empty() ? "does not say what it is: its name has no ending"
                                          : fmt::format("'{}' files cannot be read by this version", ending);
  const bool packed = ending == ".gz" || ending == ".zip";
  return {{.file = name,
           .message = fmt::format("{}; it reads .stl, .obj, .ply{}: {}", what,
                                  step_can_be_read() ? ", .off, .step and .iges" : " and .off",
                                  packed ? "unpack it first" : "export the model as one of them")}};
}

Diagnostics read_by_ending(const std::filesystem::path& file, std::string_view bytes,
                           const std::string& ending, const LoadOptions& options, Model& model) {
  const std::string name = file.string();
  const double scale = millimetres(model.unit);
  if (is_step(ending)) return load_step(file, bytes, options, model);
  if (is_iges(ending)) return load_iges(file, bytes, options, model);
  if (ending == ".obj") return load_obj(bytes, name, scale, model);
  if (ending == ".ply") return load_ply(bytes, name, scale, model);
  if (ending == ".off") return load_off(bytes, name, scale, model);
  if (ending != ".stl") return unreadable(name, ending);
  switch (stl_kind(bytes)) {
    case StlKind::binary: return load_binary_stl(bytes, name, scale, model);
    case StlKind::ascii: return load_ascii_stl(bytes, name, scale, model);
    case StlKind::neither: break;
  }
  return {{.file = name,
           .message = fmt::format("is neither a binary nor an ASCII STL file ({} bytes); export it again",
                                  bytes.size())}};
}

// With a byte order mark, or the zeros that Latin letters get.
bool utf16(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return true;
  if (bytes.size() < 4) return false;
  const bool little = bytes[0] != 0 && bytes[1] == 0 && bytes[2] != 0 && bytes[3] == 0;
  const bool big = bytes[0] == 0 && bytes[1] != 0 && bytes[2] == 0 && bytes[3] != 0;
  return little || big;
}

// The bytes without the mark that some editors put in front of UTF-8.
Result<std::string_view> readable_bytes(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) return Diagnostics{{.file = name, .message = "is empty; export it again"}};
  if (has_announced_size(bytes)) return bytes;
  if (utf16(bytes)) return Diagnostics{{.file = name, .message = "is UTF-16 text; save it as UTF-8"}};
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  return bytes;
}

std::string length_text(double mm) {
  return mm < 1e5 ? fmt::format("{:.4g} mm", mm) : fmt::format("{:.0f} mm", mm);
}

// Lengths that no vehicle or part has in the unit that was assumed or declared.
void warn_of_size(Model& model, const std::string& name) {
  const Vec3d e = model.box.extent();
  const double longest = std::max({e.x, e.y, e.z});
  const bool small = longest < 10;
  if (!small && longest <= 100'000) return;
  const Unit other = small ? Unit::m : Unit::mm;
  const std::string instead =
      model.unit == other ? (small ? "a length that no part has" : "a length that no vehicle has")
                          : fmt::format("{} if the file is in {}: give --units {}",
                                        length_text(longest / millimetres(model.unit) * millimetres(other)),
                                        small ? "metres" : "millimetres", gabarit::name(other));
  model.warnings.push_back({.level = Diagnostic::Level::warning,
                            .file = name,
                            .message = fmt::format("implausible size: {} long in {} as {}; {}",
                                                   length_text(longest), gabarit::name(model.unit),
                                                   model.unit_declared ? "declared" : "assumed", instead)});
}

Diagnostics nothing_to_measure(const Model& model, const std::string& name) {
  const Defects& d = model.defects;
  return {{.file = name,
           .message =
               model.mesh.facet_count() == 0
                   ? "holds no facet; points, lines and empty solids have no surface to measure"
                   : fmt::format("none of its {} facets can be measured: {} have a coordinate that is not a "
                                 "number or infinite, {} have no area; export it again",
                                 model.mesh.facet_count(), d.not_finite, d.degenerate)}};
}

// The hash of the file's bytes, computed beside the reading; given up when the reading fails.
class HashTask {
 public:
  HashTask(std::span<const std::uint8_t> bytes, bool beside)
      : hash_(std::async(beside ? std::launch::async : std::launch::deferred,
                         [bytes, stop = stop_.get_token()] { return sha256(bytes, stop); })) {}
  HashTask(const HashTask&) = delete;
  HashTask& operator=(const HashTask&) = delete;
  ~HashTask() { stop_.request_stop(); }
  std::string get() { return hash_.get(); }

 private:
  std::stop_source stop_;
  std::future<std::string> hash_;
};

}  // namespace

Result<Model> load(const std::filesystem::path& file, const LoadOptions& options) {
  const auto progress = [&](const char* stage, double fraction) {
    if (options.progress) options.progress(stage, fraction);
  };
  const std::string name = file.string();
  Result<MappedFile> mapped = MappedFile::open(file);
  if (!mapped) return mapped.error();
  const Result<std::string_view> bytes = readable_bytes(mapped->text(), name);
  if (!bytes) return bytes.error();

  Model model;
  model.file = valid_utf8(file.filename().string());
  model.unit = options.unit.value_or(Unit::mm);
  model.unit_declared = options.unit.has_value();
  model.sag = options.sag;
  HashTask hash(mapped->bytes(), options.threads != 1);
  progress("reading", 0);
  const std::string ending = ending_to_read(file, *bytes, model);
  if (Diagnostics errors = read_by_ending(file, *bytes, ending, options, model); !errors.empty())
    return errors;
  if (options.facet_size && !model.brep)
    model.warnings.push_back({.level = Diagnostic::Level::warning,
                              .file = name,
                              .message =
                                  "the facets stay as they are in the file: a facet size is for those made "
                                  "of the exact surfaces of STEP and IGES"});
  model.box = bounding_box(model.mesh);
  progress("counting defects", 0.7);
  model.defects = count_defects(model.mesh);
  if (model.defects.not_finite + model.defects.degenerate >= model.mesh.facet_count())
    return nothing_to_measure(model, name);
  warn_of_size(model, name);
  model.sha256 = hash.get();
  progress("reading", 1);
  return model;
}

}  // namespace gabarit
