#include "model/load.h"

#include <algorithm>
#include <cctype>
#include <future>

#include <fmt/format.h>

#include "model/load_openmesh.h"
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
  const std::string_view start = bytes.substr(0, 64);
  if (start.starts_with("ply\n") || start.starts_with("ply\r")) return ".ply";
  if (start.starts_with("OFF") || start.starts_with("COFF") || start.starts_with("NOFF")) return ".off";
  if (start.starts_with("glTF")) return ".glb";
  if (start.starts_with("ISO-10303-21")) return ".step";
  if (stl_kind(bytes) != StlKind::neither) return ".stl";
  return "";
}

Diagnostics read_by_ending(const std::filesystem::path& file, std::string_view bytes,
                           const std::string& ending, double scale, Model& model) {
  const std::string name = file.string();
  if (ending == ".stl") {
    switch (stl_kind(bytes)) {
      case StlKind::binary: return load_binary_stl(bytes, name, scale, model);
      case StlKind::ascii: return load_ascii_stl(bytes, name, scale, model);
      case StlKind::neither: break;
    }
    return {{.file = name,
             .message = fmt::format("is neither a binary nor an ASCII STL file ({} bytes); export it again",
                                    bytes.size())}};
  }
  if (ending == ".obj" || ending == ".ply" || ending == ".off")
    return load_openmesh(file, bytes, ending, scale, model);
  return {{.file = name,
           .message = fmt::format(
               "'{}' files cannot be read by this version; it reads .stl, .obj, .ply and .off", ending)}};
}

bool utf16(std::string_view bytes) { return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"); }

// Lengths that no vehicle or part has in the unit that was assumed or declared.
void warn_of_size(Model& model, const std::string& name) {
  const Vec3d e = model.box.extent();
  const double longest = std::max({e.x, e.y, e.z});
  const double in_file = longest / millimetres(model.unit);
  std::string other;
  if (longest < 10) other = fmt::format("{:.4g} mm if the file is in metres: give --units m", in_file * 1000);
  if (longest > 100'000)
    other = fmt::format("{:.4g} mm if the file is in millimetres: give --units mm", in_file);
  if (longest > 100'000 && model.unit == Unit::mm) other = "a length that no vehicle has";
  if (other.empty()) return;
  model.warnings.push_back({.level = Diagnostic::Level::warning,
                            .file = name,
                            .message = fmt::format("implausible size: {:.4g} mm long as {}; {}", longest,
                                                   gabarit::name(model.unit), other)});
}

std::string content_ending(const std::filesystem::path& file, std::string_view bytes, Model& model) {
  const std::string named = lower_ending(file);
  const std::string found = ending_of_content(bytes);
  const bool known = named == ".stl" || named == ".obj" || named == ".ply" || named == ".off";
  if (found.empty() || found == named || (known && found == ".stl" && named == ".obj"))
    return named.empty() ? "(none)" : named;
  if (known || named.empty()) {
    model.warnings.push_back(
        {.level = Diagnostic::Level::warning,
         .file = file.string(),
         .message = fmt::format("the content is {}, whatever the name says", found.substr(1))});
    return found;
  }
  return named;
}

Diagnostics no_facets(const std::string& name) {
  return {
      {.file = name,
       .message = "holds no facet that could be measured; points, lines and empty solids have no surface"}};
}

}  // namespace

Result<Model> load(const std::filesystem::path& file, const LoadOptions& options) {
  const auto progress = [&](const char* stage, double fraction) {
    if (options.progress) options.progress(stage, fraction);
  };
  const std::string name = file.string();
  Result<MappedFile> mapped = MappedFile::open(file);
  if (!mapped) return mapped.error();
  const std::string_view bytes = mapped->text();
  if (bytes.empty()) return Diagnostics{{.file = name, .message = "is empty"}};
  if (utf16(bytes)) return Diagnostics{{.file = name, .message = "is UTF-16 text; save it as UTF-8"}};

  Model model;
  model.file = valid_utf8(file.filename().string());
  model.unit = options.unit.value_or(Unit::mm);
  model.unit_declared = options.unit.has_value();
  model.sag = options.sag;
  auto hash = std::async(options.threads == 1 ? std::launch::deferred : std::launch::async,
                         [&] { return sha256(mapped->bytes()); });
  progress("reading", 0);
  const std::string ending = content_ending(file, bytes, model);
  if (Diagnostics errors = read_by_ending(file, bytes, ending, millimetres(model.unit), model);
      !errors.empty())
    return errors;
  model.box = bounding_box(model.mesh);
  progress("counting defects", 0.7);
  model.defects = count_defects(model.mesh);
  if (model.defects.not_finite + model.defects.degenerate >= model.mesh.facet_count()) return no_facets(name);
  warn_of_size(model, name);
  model.sha256 = hash.get();
  progress("reading", 1);
  return model;
}

}  // namespace gabarit
