#include "cli/devices.h"

#include <thread>

#include <fmt/format.h>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/messages.h"
#include "gpu/device_memory.h"
#include "gpu/device_trial.h"

namespace gabarit {

Device choose_device(const std::string& name, int threads) {
  if (name == "cpu") return Device::cpu(threads);
  const auto count = static_cast<int>(cuda_devices().size());
  std::string trouble = "no CUDA device can be used here";
  for (int i = 0; i < count; ++i) {
    const Device device = Device::cuda(i, threads);
    trouble = trial_of(device);
    if (trouble.empty()) return device;
  }
  if (name == "cuda") throw UsageError{trouble + "; choose --device cpu or auto"};
  return Device::cpu(threads);
}

static int list_devices() {
  std::string text = fmt::format("cpu     {} threads\n", std::thread::hardware_concurrency());
  const auto names = cuda_devices();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string trouble = trial_of(Device::cuda(static_cast<int>(i)));
    text += fmt::format("cuda    {}{}\n", names[i], trouble.empty() ? "" : ": not used, " + trouble);
  }
  if (names.empty()) text += "cuda    none can be used here\n";
  print_result(text);
  return exit_clean;
}

Command devices_command(CLI::App& app) {
  return {app.add_subcommand("devices", "List what can compute."), list_devices};
}

}  // namespace gabarit
