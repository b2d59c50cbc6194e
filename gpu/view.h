// A run of elements in the memory of the device that uses it; what kernels hold instead of containers.
#pragma once

#include <cstdint>
#include <span>

#include "gpu/qualifiers.h"

namespace gabarit {

template <class T>
struct View {
  T* data = nullptr;
  std::int64_t size = 0;

  GABARIT_HD T& operator[](std::int64_t i) const { return data[i]; }
};

template <class T>
View<T> view(std::span<T> elements) {
  return {elements.data(), static_cast<std::int64_t>(elements.size())};
}

}  // namespace gabarit
