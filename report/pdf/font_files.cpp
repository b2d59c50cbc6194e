#include "report/pdf/font_files.h"

#include <array>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>

namespace gabarit::pdf {

namespace fs = std::filesystem;

static constexpr std::array fallback_names{"NotoSansJP-Regular.ttf",
                                           "NotoSansCJK-Regular.ttf",
                                           "ipag.ttf",
                                           "ipagp.ttf",
                                           "ipaexg.ttf",
                                           "VL-Gothic-Regular.ttf",
                                           "TakaoGothic.ttf",
                                           "fonts-japanese-gothic.ttf",
                                           "wqy-microhei.ttc",
                                           "wqy-zenhei.ttc",
                                           "unifont.ttf",
                                           "DroidSansFallbackFull.ttf"};

using FilesByName = std::map<std::string, fs::path>;

// The first file of a name wins; folders that can't be read hold nothing.
static void add_files(const fs::path& folder, FilesByName& files) {
  std::error_code error;
  fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && it != fs::recursive_directory_iterator(); it.increment(error)) {
    std::error_code unreadable;
    if (it->is_regular_file(unreadable)) files.emplace(it->path().filename().string(), it->path());
  }
}

static fs::path named(const FilesByName& files, const char* name) {
  const auto found = files.find(name);
  return found == files.end() ? fs::path() : found->second;
}

FontFiles find_fonts(const std::vector<fs::path>& folders) {
  FilesByName files;
  for (const fs::path& folder : folders) add_files(folder, files);
  FontFiles fonts;
  fonts.regular = named(files, "DejaVuSans.ttf");
  fonts.bold = named(files, "DejaVuSans-Bold.ttf");
  fonts.mono = named(files, "DejaVuSansMono.ttf");
  for (const char* const name : fallback_names) {
    if (fs::path file = named(files, name); !file.empty()) fonts.fallbacks.push_back(std::move(file));
  }
  return fonts;
}

static std::vector<fs::path> usual_folders(const fs::path& installed) {
  std::vector<fs::path> folders;
  if (const char* const named_by_user = std::getenv("GABARIT_FONTS")) {
    std::istringstream list(named_by_user);
    for (std::string folder; std::getline(list, folder, ':');) {
      if (!folder.empty()) folders.emplace_back(folder);
    }
    return folders;
  }
  if (!installed.empty()) folders.push_back(installed / "fonts");
  if (const char* const home = std::getenv("HOME")) {
    folders.push_back(fs::path(home) / ".local/share/fonts");
    folders.push_back(fs::path(home) / ".fonts");
  }
  folders.insert(folders.end(), {"/usr/local/share/fonts", "/usr/share/fonts"});
  return folders;
}

FontFiles find_usual_fonts(const fs::path& installed) { return find_fonts(usual_folders(installed)); }

}  // namespace gabarit::pdf
