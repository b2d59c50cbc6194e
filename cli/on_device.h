// What happens to a run when its device fails on the way.
#pragma once

#include <string>

#include "gpu/device.h"
#include "gpu/device_error.h"

namespace gabarit {

// Gives work(device). When the device is lost or too small for the model, all of it is begun again on the
// CPU, after notice(what went wrong): one device computed everything that a report says. With `by_name` the
// user asked for this device and none other: DeviceError is let through.
template <class Work, class Notice>
auto on_device(const Device& device, bool by_name, Work&& work, Notice&& notice) {
  if (!device.has_own_memory() || by_name) return work(device);
  try {
    return work(device);
  } catch (const DeviceError& error) {
    notice(std::string(error.what()));
  }
  return work(device.host());
}

}  // namespace gabarit
