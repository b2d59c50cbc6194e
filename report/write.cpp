#include "report/write.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "report/display_unit.h"
#include "report/output_set.h"
#include "report/write_json.h"
#include "report/write_junit.h"
#include "report/write_pdf.h"
#include "report/write_ply.h"
#include "report/write_sarif.h"
#include "report/write_stl.h"

namespace gabarit {

namespace {

struct Output {
  std::string name;
  std::function<void(OutputFile&)> write;
};

}  // namespace

static Output text_output(const std::string& name, std::string (*text)(const Report&), const Report& report) {
  return {name, [text, &report](OutputFile& file) { file.write(text(report)); }};
}

static Output stl_output(const Report& report, const std::string& name, const std::string& what,
                         std::vector<FacetId> facets) {
  const std::string title = fmt::format("Gabarit {} {}, mm", report.version, what);
  return {name, [&report, title, facets = std::move(facets)](OutputFile& file) {
            write_stl(report.model->mesh, facets, title, file);
          }};
}

static Output field_output(const Report& report, const RuleResult& result) {
  return {"fields/" + result.rule.id + ".ply", [&](OutputFile& file) {
            const Measure* const measure = result.rule.require.measure;
            const double factor = measure != nullptr ? display_unit(measure->dimension).factor : 1;
            write_ply({&report.model->mesh, &result.region, &result.field, &result.facet_verdicts, factor,
                       fmt::format("Gabarit {} rule {}", report.version, result.rule.id)},
                      file);
          }};
}

static void add_stl(const Report& report, std::vector<Output>& outputs) {
  outputs.push_back(
      stl_output(report, "violations.stl", "all failing facets", failing_facets(*report.outcome)));
  for (const RuleResult& result : report.outcome->results) {
    std::vector<FacetId> facets = failing_facets(result);
    if (facets.empty()) continue;
    outputs.push_back(stl_output(report, "violations/" + result.rule.id + ".stl",
                                 "failing facets of " + result.rule.id, std::move(facets)));
  }
}

static Output pdf_output(const Report& report, const WriteOptions& options) {
  return {"report.pdf", [&](OutputFile& file) {
            PdfOptions pdf;
            pdf.device = Device::cpu(options.threads);
            pdf.palette = options.palette;
            pdf.installed = options.installed;
            write_pdf(report, pdf, file);
          }};
}

static void add(Format format, const Report& report, const WriteOptions& options,
                std::vector<Output>& outputs) {
  switch (format) {
    case Format::json: return outputs.push_back(text_output("results.json", results_json, report));
    case Format::junit: return outputs.push_back(text_output("junit.xml", junit_xml, report));
    case Format::sarif: return outputs.push_back(text_output("results.sarif", sarif_json, report));
    case Format::stl: return add_stl(report, outputs);
    case Format::pdf: return outputs.push_back(pdf_output(report, options));
    case Format::html: break;
  }
  throw std::invalid_argument("this version does not write this format");
}

static std::vector<Output> outputs_of(const Report& report, const WriteOptions& options) {
  std::vector<Format> formats = options.formats;
  std::sort(formats.begin(), formats.end());
  formats.erase(std::unique(formats.begin(), formats.end()), formats.end());
  std::vector<Output> outputs;
  for (const Format format : formats) add(format, report, options, outputs);
  if (options.fields) {
    // A rule that was not run has no field; an empty file would read as one that found nothing.
    for (const RuleResult& result : report.outcome->results) {
      if (result.verdict != Verdict::not_run) outputs.push_back(field_output(report, result));
    }
  }
  if (options.run_record) {
    outputs.push_back({"run.json", [&](OutputFile& file) { file.write(options.run_record()); }});
  }
  return outputs;
}

static std::string reason(const std::filesystem::filesystem_error& error) {
  const bool busy = error.code() == std::errc::operation_would_block;
  return busy ? "another run is writing here; wait for it or choose another folder"
              : "cannot write: " + error.code().message();
}

Result<std::vector<std::string>> write(const Report& report, const std::filesystem::path& folder,
                                       const WriteOptions& options) {
  const std::vector<Output> outputs = outputs_of(report, options);
  std::filesystem::path current = folder;
  try {
    OutputSet set(folder);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      if (options.progress)
        options.progress("write", static_cast<double>(i) / static_cast<double>(outputs.size()));
      current = folder / outputs[i].name;
      set.add(outputs[i].name, outputs[i].write);
    }
    current = folder;
    return set.commit();
  } catch (const std::filesystem::filesystem_error& error) {
    return Diagnostics{
        {.level = Diagnostic::Level::error, .file = current.string(), .message = reason(error)}};
  }
}

}  // namespace gabarit
