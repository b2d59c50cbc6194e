// A value or the reasons why there is none; the member names of std::expected, which this compiler lacks.
#pragma once

#include <utility>
#include <variant>
#include <vector>

#include "model/diagnostic.h"

namespace gabarit {

using Diagnostics = std::vector<Diagnostic>;

template <class T, class E = Diagnostics>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  Result(E error) : content_(std::in_place_index<1>, std::move(error)) {}

  bool has_value() const { return content_.index() == 0; }
  explicit operator bool() const { return has_value(); }
  T& value() { return std::get<0>(content_); }
  const T& value() const { return std::get<0>(content_); }
  E& error() { return std::get<1>(content_); }
  const E& error() const { return std::get<1>(content_); }
  T& operator*() { return value(); }
  const T& operator*() const { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

 private:
  std::variant<T, E> content_;
};

}  // namespace gabarit
