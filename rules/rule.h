// A rule file after reading: plain data, every name resolved, every quantity in millimetres and radians.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "checks/check.h"

namespace gabarit {

struct Place {
  std::string file;
  int line = 0, column = 0;  // from 1
};

// A tree of selectors; `all` without children is the whole model.
struct Where {
  enum class Kind { all, any, none_of, selector };
  Kind kind = Kind::all;
  std::vector<Where> children;  // of all and any; exactly one of none_of (`not`)
  const Selector* selector = nullptr;
  Arguments arguments;
  Place place;
};

struct Limit {
  enum class Kind { at_least, at_most, between };
  Kind kind = Kind::at_least;
  double low = 0;   // of at_least and between
  double high = 0;  // of at_most and between
};

struct Requirement {
  const Measure* measure = nullptr;
  Arguments arguments;
  Limit limit;
  std::string limit_text;  // as written, such as "at least 4 mm"
};

enum class Severity { error, warning, note };

struct Rule {
  std::string id, title, clause;
  Severity severity = Severity::error;
  Where where;
  Requirement require;
  double ignore_area = 0;  // mm²: findings under it are counted, not listed
  Place place;
};

enum class Ground { lowest, height };

struct Source {
  std::string document, edition, address, status;
};

struct RuleSet {
  std::string file;  // without its folder
  std::string text;  // the file as read, for the report's annex
  std::string sha256;
  std::string id, title, revision;
  Source source;
  Vec3d up{0, 0, 1}, forward{-1, 0, 0};
  Ground ground = Ground::lowest;
  double ground_height = 0;
  std::optional<double> sag;
  std::vector<Rule> rules;
};

}  // namespace gabarit
