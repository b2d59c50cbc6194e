#include "report/earlier_run.h"

#include <fstream>
#include <string>
#include <vector>

namespace gabarit {

namespace fs = std::filesystem;

static bool begins_like_ours(const fs::path& file, const std::string& mark) {
  std::string start(160, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  return start.find(mark) != std::string::npos;
}

// Files of the folder with the extension that carry our mark; the folder too, when that empties it.
static void remove_marked(const fs::path& folder, const std::string& extension, const std::string& mark) {
  if (!fs::is_directory(folder)) return;
  std::vector<fs::path> ours;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const bool candidate = entry.is_regular_file() && entry.path().extension() == extension;
    if (candidate && begins_like_ours(entry.path(), mark)) ours.push_back(entry.path());
  }
  for (const fs::path& file : ours) fs::remove(file);
  if (!ours.empty() && fs::is_empty(folder)) fs::remove(folder);
}

void remove_earlier_run(const fs::path& folder) {
  remove_marked(folder / "violations", ".stl", "Gabarit ");
  remove_marked(folder / "fields", ".ply", "comment Gabarit ");
  if (!begins_like_ours(folder / "results.json", "gabarit.results/")) return;
  for (const char* const name : {"report.pdf", "report.html", "violations.stl", "junit.xml", "results.sarif",
                                 "run.json", "results.json"}) {
    const fs::path place = folder / name;
    if (!fs::is_directory(place)) fs::remove(place);
  }
}

}  // namespace gabarit
