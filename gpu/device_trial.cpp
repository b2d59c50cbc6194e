#include "gpu/device_trial.h"

#include <exception>

#include "gpu/bumpy_ball.h"
#include "gpu/query_trials.h"

namespace gabarit {

static std::vector<std::uint64_t> answers(const QueryTrial& trial, const Device& device,
                                          const FacetSurface& surface) {
  const PreparedTrial prepared = trial.prepare(device, surface);
  prepared.run();
  return prepared.bits();
}

static std::string compare(const Device& device) {
  const FacetSurface surface = bumpy_ball(16, 24, 10, 0.2);
  for (const QueryTrial& trial : query_trials()) {
    if (answers(trial, device, surface) != answers(trial, device.host(), surface)) {
      return "CUDA device " + std::to_string(device.index) + " cannot be trusted: its answers to \"" +
             trial.name + "\" are not those of the CPU";
    }
  }
  return {};
}

std::string trial_of(const Device& device) {
  try {
    return compare(device);
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace gabarit
