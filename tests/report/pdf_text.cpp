#include "tests/report/pdf_text.h"

#include <array>
#include <cstdio>
#include <regex>
#include <stdexcept>

#include "tests/temporary_folder.h"

namespace gabarit {

PdfOptions quick_pdf() {
  PdfOptions options;
  options.resolution = 25;
  return options;
}

static std::string output_of(const std::string& command) {
  std::FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    text.append(buffer.data(), count);
  if (pclose(pipe) != 0) throw std::runtime_error("failed: " + command);
  return text;
}

// The file is complained of when poppler does.
static std::string read_back(const Report& report, const PdfOptions& options, const std::string& arguments) {
  const TemporaryFolder folder;
  OutputFile file(folder / "report.pdf");
  write_pdf(report, options, file);
  file.commit();
  const std::string complaints = (folder / "complaints").string();
  std::string text = output_of("pdftotext " + arguments + " '" + (folder / "report.pdf").string() +
                               "' - 2> '" + complaints + "'");
  if (const std::string said = content(complaints); !said.empty())
    throw std::runtime_error("poppler: " + said);
  return text;
}

std::string pdf_bytes(const Report& report, const PdfOptions& options) {
  const TemporaryFolder folder;
  OutputFile file(folder / "report.pdf");
  write_pdf(report, options, file);
  file.commit();
  return content(folder / "report.pdf");
}

static std::string with_single_spaces(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool space = c == ' ' || c == '\n';
    if (!space || (!result.empty() && result.back() != ' ')) result += space ? ' ' : c;
  }
  return result;
}

std::vector<std::string> pdf_pages(const Report& report, const PdfOptions& options) {
  const std::string text = read_back(report, options, "-layout");
  std::vector<std::string> pages;
  for (std::size_t from = 0, end = 0; (end = text.find('\f', from)) != std::string::npos; from = end + 1) {
    pages.push_back(with_single_spaces(text.substr(from, end - from)));
  }
  return pages;
}

std::string pdf_text(const Report& report, const PdfOptions& options) {
  std::string text;
  for (const std::string& page : pdf_pages(report, options)) text += page + "\n";
  return text;
}

std::vector<Word> pdf_words(const Report& report, const PdfOptions& options) {
  const std::string text = read_back(report, options, "-bbox");
  static const std::regex pattern(
      "<word xMin=\"([-0-9.]+)\" yMin=\"([-0-9.]+)\" xMax=\"([-0-9.]+)\" yMax=\"([-0-9.]+)\">([^<]*)</word>");
  std::vector<Word> words;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
    words.push_back(
        {std::stod((*it)[1]), std::stod((*it)[2]), std::stod((*it)[3]), std::stod((*it)[4]), (*it)[5]});
  }
  return words;
}

}  // namespace gabarit
