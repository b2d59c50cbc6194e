#include <gmock/gmock.h>

#include "report/pdf/fonts.h"
#include "tests/report/pdf_text.h"
#include "tests/report/sample_report.h"
#include "tests/temporary_folder.h"

namespace gabarit {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

// A folder with DejaVu and nothing else.
void put_dejavu(const fs::path& folder) {
  const pdf::FontFiles files = pdf::find_usual_fonts({});
  for (const fs::path& file : {files.regular, files.bold, files.mono}) {
    ASSERT_FALSE(file.empty()) << "fonts-dejavu-core is not installed";
    fs::create_symlink(file, folder / file.filename());
  }
}

std::string text_with(const std::string& part, const std::vector<fs::path>& folders) {
  SampleReport sample;
  sample.model.file = part;
  PdfOptions options = quick_pdf();
  options.font_folders = folders;
  return pdf_text(sample.report(), options);
}

TEST(pdf_fonts, greek_and_cyrillic_names_come_back) {
  const TemporaryFolder folder;
  put_dejavu(folder.path());
  const std::string name = "Ωμέγα Бензобак façade ≥ ½.stl";
  const std::string text = text_with(name, {folder.path()});
  EXPECT_THAT(text, AllOf(HasSubstr(name), Not(HasSubstr("No font at hand"))));
}

TEST(pdf_fonts, japanese_without_a_font_for_it_is_visibly_replaced_and_named) {
  const TemporaryFolder folder;
  put_dejavu(folder.path());
  const std::string text = text_with("燃料タンク.stl", {folder.path()});
  EXPECT_THAT(text, AllOf(HasSubstr("□□□□□.stl"), HasSubstr("each is drawn as □"), HasSubstr("U+71C3")));
}

TEST(pdf_fonts, japanese_with_a_font_for_it_comes_back) {
  if (pdf::find_usual_fonts({}).fallbacks.empty()) GTEST_SKIP() << "no Japanese font on this machine";
  SampleReport sample;
  sample.model.file = "燃料タンク.stl";
  EXPECT_THAT(pdf_text(sample.report()), HasSubstr("燃料タンク.stl"));
}

TEST(pdf_fonts, without_dejavu_there_is_a_report_that_says_so) {
  const TemporaryFolder folder;
  const std::string text = text_with("Ωμέγα façade.stl", {folder.path()});
  EXPECT_THAT(text, AllOf(HasSubstr("????? façade.stl"), HasSubstr("DejaVu Sans was not found"),
                          HasSubstr("U+03A9")));
}

TEST(pdf_fonts, a_file_that_is_no_font_is_passed_over) {
  const TemporaryFolder folder;
  put(folder / "DejaVuSans.ttf", "no font");
  put(folder / "sub/ipag.ttf", std::string(100, '\0'));
  EXPECT_THAT(text_with("part.stl", {folder.path()}), HasSubstr("DejaVu Sans was not found"));
  const TemporaryFolder other;
  put_dejavu(other.path());
  put(other / "ipag.ttf", "no font either");
  EXPECT_THAT(text_with("日.stl", {other.path()}), HasSubstr("□.stl"));
}

TEST(pdf_fonts, the_folders_of_the_environment_go_before_all_others) {
  const TemporaryFolder folder;
  setenv("GABARIT_FONTS", folder.path().c_str(), 1);
  EXPECT_TRUE(pdf::find_usual_fonts({}).regular.empty());
  unsetenv("GABARIT_FONTS");
  EXPECT_FALSE(pdf::find_usual_fonts({}).regular.empty());
}

}  // namespace
}  // namespace gabarit
