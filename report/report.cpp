#include "report/report.h"

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <ctime>

#include <fmt/format.h>

#include "model/sha256.h"
#include "report/version.h"

namespace gabarit {

// ISO 8601 in UTC; empty for anything that is not a plain number of seconds within the years of four digits.
static std::string date_of_epoch(const char* text) {
  if (text == nullptr) return {};
  const std::string digits = text;
  std::int64_t seconds = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), seconds);
  constexpr std::int64_t year_10000 = 253402300800;
  if (error != std::errc() || end != digits.data() + digits.size() || seconds < 0 || seconds >= year_10000) {
    return {};
  }
  const auto time = static_cast<std::time_t>(seconds);
  std::tm utc{};
  gmtime_r(&time, &utc);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday,
                     utc.tm_hour, utc.tm_min, utc.tm_sec);
}

// Everything that decides the content of a report, one item a line.
static std::string identity(const Model& model, const Outcome& outcome) {
  std::string text = fmt::format("gabarit {}\nmodel {}\nfile {}\nunit {}\ndevice {}\n", program_version,
                                 model.sha256, model.file, name(model.unit), outcome.device);
  for (const RuleSet& set : outcome.rulesets) text += fmt::format("rules {} {}\n", set.id, set.sha256);
  for (const Setup& setup : outcome.setups)
    text += fmt::format("sag {} ground {}\n", setup.sag, setup.frame.ground);
  for (const RuleResult& result : outcome.results) text += fmt::format("rule {}\n", result.rule.id);
  return text;
}

Report make_report(const Model& model, const Outcome& outcome) {
  Report report;
  report.model = &model;
  report.outcome = &outcome;
  report.id = sha256(identity(model, outcome)).substr(0, 12);
  report.version = program_version;
  report.date = date_of_epoch(std::getenv("SOURCE_DATE_EPOCH"));
  return report;
}

}  // namespace gabarit
