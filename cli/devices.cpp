#include "cli/devices.h"

#include <thread>

#include <fmt/format.h>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/messages.h"
#include "gpu/device_memory.h"

namespace gabarit {

Device choose_device(const std::string& name, int threads) {
  if (name != "cuda") return Device::cpu(threads);
  throw UsageError{cuda_devices().empty()
                       ? "no CUDA device can be used here; choose --device cpu or auto"
                       : "the checks of this version compute on the CPU; choose --device cpu or auto"};
}

static int list_devices() {
  std::string text = fmt::format("cpu     {} threads\n", std::thread::hardware_concurrency());
  for (const std::string& device : cuda_devices()) text += fmt::format("cuda    {}\n", device);
  if (cuda_devices().empty()) text += "cuda    none can be used here\n";
  print_result(text);
  return exit_clean;
}

Command devices_command(CLI::App& app) {
  return {app.add_subcommand("devices", "List what can compute."), list_devices};
}

}  // namespace gabarit
