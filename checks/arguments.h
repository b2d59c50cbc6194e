// Parameters of selectors and measures as their descriptors declare them, and the values given to them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "gpu/vec3.h"

namespace gabarit {

// Millimetres, square millimetres and radians inside; `point` is three lengths, `direction` three plain
// numbers.
enum class Dimension { length, area, angle, number, count, choice, text, point, direction };

struct Parameter {
  std::string name;  // as written in a rule file, such as "separation"
  Dimension dimension = Dimension::length;
  std::string documentation;                     // one sentence
  std::optional<std::string> default_text = {};  // as a user would write it; none: the parameter is required…
  bool optional = false;                         // …unless it may be absent altogether
  std::vector<std::string> choices = {};         // of a choice; of a direction: the names it also goes by
  double least = -1e300;                         // smallest and greatest value allowed, inside units
  double greatest = 1e300;
};

using Value = std::variant<double, std::string, Vec3d>;

// Every parameter with a default is present: the rule reader fills it in. Asking for one that is absent is a
// bug (assert).
class Arguments {
 public:
  void set(const std::string& name, Value value) { values_[name] = std::move(value); }
  bool has(const std::string& name) const { return values_.contains(name); }
  double number(const std::string& name) const { return std::get<double>(values_.at(name)); }
  const std::string& text(const std::string& name) const { return std::get<std::string>(values_.at(name)); }
  const Vec3d& vector(const std::string& name) const { return std::get<Vec3d>(values_.at(name)); }
  const std::map<std::string, Value>& all() const { return values_; }

 private:
  std::map<std::string, Value> values_;
};

}  // namespace gabarit
