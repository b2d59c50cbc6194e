#include "cli/check_options.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "cli/messages.h"
#include "rules/nearest_name.h"

namespace gabarit {

void CheckOptions::add_to(CLI::App& command) {
  model.add_file_to(command);
  command.add_option("--rules", rules, "Rule file or installed pack; may be given again")
      ->required()
      ->type_name("FILE")
      ->allow_extra_args(false);
  command.add_option("--out", out, "Folder for the outputs; created if missing")
      ->required()
      ->type_name("DIR");
  model.add_options_to(command);
  command.add_option("--formats", formats, "Of pdf,stl,json,junit,sarif [pdf,stl,json]")->type_name("LIST");
  command.add_flag("--fields", fields, "Also write fields/RULE.ply");
  command.add_option("--only", only, "Run these rules and no others")
      ->delimiter(',')
      ->type_name("RULE")
      ->allow_extra_args(false);
  command.add_option("--fail-on", fail_on, "fail, undecided or never [fail]")
      ->check(CLI::IsMember({"fail", "undecided", "never"}).description(""))
      ->type_name("WHEN");
  command.add_option("--device", device, "auto, cpu or cuda [auto]")
      ->check(CLI::IsMember({"auto", "cpu", "cuda"}).description(""))
      ->type_name("NAME");
  command.add_option("--palette", palette, "Of heat maps: by-limit or red-to-blue [by-limit]")
      ->check(CLI::IsMember({"by-limit", "red-to-blue"}).description(""))
      ->type_name("NAME");
  command.add_flag("--quiet", quiet, "Print nothing but warnings and errors");
}

static constexpr std::array<std::pair<const char*, Format>, 5> format_names{{{"pdf", Format::pdf},
                                                                             {"stl", Format::stl},
                                                                             {"json", Format::json},
                                                                             {"junit", Format::junit},
                                                                             {"sarif", Format::sarif}}};

static Format format_named(const std::string& name) {
  std::vector<std::string> known;
  for (const auto& [known_name, format] : format_names) {
    if (name == known_name) return format;
    known.emplace_back(known_name);
  }
  if (name == "html") throw UsageError{"--formats: this version does not write " + name};
  throw UsageError{fmt::format("--formats: no format is called `{}`: {}", name, name_hint(name, known))};
}

std::vector<Format> CheckOptions::format_list() const {
  std::vector<Format> list;
  std::istringstream words(formats);
  for (std::string word; std::getline(words, word, ',');) list.push_back(format_named(word));
  if (list.empty()) throw UsageError{"--formats: name at least one format"};
  return list;
}

FailOn CheckOptions::fail_on_value() const {
  return fail_on == "never" ? FailOn::never : fail_on == "undecided" ? FailOn::undecided : FailOn::fail;
}

ColourMap CheckOptions::palette_map() const {
  return palette == "red-to-blue" ? ColourMap::red_to_blue : ColourMap::by_limit;
}

// What follows the names of the model and of the rule files.
static void add_settings(const CheckOptions& options, std::vector<std::string>& words) {
  if (!options.model.units.empty()) words.insert(words.end(), {"--units", options.model.units});
  if (!options.model.sag.empty()) words.insert(words.end(), {"--sag", options.model.sag});
  if (!options.model.facet_size.empty())
    words.insert(words.end(), {"--facet-size", options.model.facet_size});
  for (const std::string& rule : options.only) words.insert(words.end(), {"--only", rule});
  if (options.palette_map() != ColourMap::by_limit) words.insert(words.end(), {"--palette", options.palette});
}

std::vector<std::string> CheckOptions::command() const {
  std::vector<std::string> words{"gabarit", "check", model.file};
  for (const std::string& file : rules) words.insert(words.end(), {"--rules", file});
  add_settings(*this, words);
  words.insert(words.end(), {"--out", out, "--formats", formats, "--device", device, "--fail-on", fail_on});
  if (fields) words.emplace_back("--fields");
  if (quiet) words.emplace_back("--quiet");
  return words;
}

std::vector<std::string> CheckOptions::settings(const Model& loaded, const Outcome& outcome) const {
  std::vector<std::string> words{"gabarit", "check", loaded.file};
  for (const RuleSet& set : outcome.rulesets) words.insert(words.end(), {"--rules", set.file});
  add_settings(*this, words);
  return words;
}

}  // namespace gabarit
