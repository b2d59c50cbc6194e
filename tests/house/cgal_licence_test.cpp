// The product may use only the parts of CGAL under the LGPL (kernels, number types): a GPL package would
// change the licence of every binary that is handed on.
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/house/includes.h"

namespace gabarit::house {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

// Headers under the GPL that `header` brings in, itself included; `seen` keeps the walk finite.
void add_gpl_headers(const fs::path& root, const std::string& header, std::set<std::string>& seen,
                     std::set<std::string>& gpl) {
  if (!seen.insert(header).second || !fs::exists(root / header)) return;
  const std::string text = text_of(root / header);
  static const std::regex licence(R"(SPDX-License-Identifier:\s*(\S+))");
  std::smatch match;
  if (std::regex_search(text, match, licence) && match[1].str().starts_with("GPL")) gpl.insert(header);
  static const std::regex include(R"(#\s*include\s*<(CGAL/[^>]+)>)");
  for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it) {
    add_gpl_headers(root, (*it)[1].str(), seen, gpl);
  }
}

TEST(CgalLicence, the_product_includes_no_header_under_the_gpl) {
  std::set<std::string> seen;
  std::set<std::string> gpl;
  for (const Include& include :
       includes(GABARIT_SOURCE_DIR, {"gpu", "model", "checks", "rules", "report", "cli"})) {
    if (include.target.starts_with("CGAL/")) add_gpl_headers(CGAL_INCLUDE_ROOT, include.target, seen, gpl);
  }
  EXPECT_THAT(gpl, testing::IsEmpty());
}

TEST(CgalLicence, a_header_under_the_gpl_would_be_found) {
  std::set<std::string> seen;
  std::set<std::string> gpl;
  add_gpl_headers(CGAL_INCLUDE_ROOT, "CGAL/Delaunay_triangulation_2.h", seen, gpl);
  EXPECT_THAT(gpl, testing::Contains("CGAL/Delaunay_triangulation_2.h"));
}

}  // namespace
}  // namespace gabarit::house
