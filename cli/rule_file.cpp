#include "cli/rule_file.h"

#include <filesystem>

#include "report/installation.h"

namespace gabarit {

std::string rule_file(const std::string& name) {
  std::error_code error;
  const std::filesystem::path given(name);
  if (std::filesystem::exists(given, error) || given.has_parent_path()) return name;
  const std::filesystem::path installed = installed_files();
  if (installed.empty()) return name;
  for (const std::string& file : {name, name + ".yaml"}) {
    const auto pack = installed / "rules" / file;
    if (std::filesystem::is_regular_file(pack, error)) return pack.string();
  }
  return name;
}

}  // namespace gabarit
