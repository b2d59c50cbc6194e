// What one facet reads, and a field filled with readings.
#pragma once

#include <limits>

#include "checks/field.h"
#include "gpu/parallel_for.h"

namespace gabarit {

// Nothing known, until something is: see Field.
struct Reading {
  double value = std::numeric_limits<double>::quiet_NaN();
  double lower = 0, upper = std::numeric_limits<double>::infinity();
  Absence absence = Absence::too_little;
  Vec3d at, contact;
};

// read(facet) for every facet of the field, `grain` of them at a time on the device's CPU threads.
template <class Read>
void fill(Field& field, const Device& device, std::int64_t grain, const Read& read) {
  field.resize(field.facets.size());
  const auto kernel = [&](std::int64_t i) {
    const auto at = static_cast<std::size_t>(i);
    const Reading r = read(field.facets[at]);
    field.value[at] = r.value;
    field.lower[at] = r.lower;
    field.upper[at] = r.upper;
    field.at[at] = r.at;
    field.contact[at] = r.contact;
    field.absence[at] = r.absence;
  };
  parallel_for_cpu(device, static_cast<std::int64_t>(field.size()), kernel, grain);
}

}  // namespace gabarit
