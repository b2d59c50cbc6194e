#include "model/model.h"

namespace gabarit {

double millimetres(Unit unit) {
  switch (unit) {
    case Unit::mm: break;
    case Unit::cm: return 10.0;
    case Unit::m: return 1000.0;
    case Unit::in: return 25.4;
  }
  return 1.0;
}

const char* name(Unit unit) {
  switch (unit) {
    case Unit::mm: break;
    case Unit::cm: return "cm";
    case Unit::m: return "m";
    case Unit::in: return "in";
  }
  return "mm";
}

std::optional<Unit> unit_named(const std::string& text) {
  for (const Unit unit : {Unit::mm, Unit::cm, Unit::m, Unit::in}) {
    if (text == name(unit)) return unit;
  }
  return std::nullopt;
}

}  // namespace gabarit
