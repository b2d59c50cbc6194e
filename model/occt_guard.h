// Runs OpenCASCADE so that nothing of it escapes: no message on the terminal, no exception, no signal.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include <Message_ProgressIndicator.hxx>

#include "model/load.h"

namespace gabarit {

// How far the work is, and whether its time is over; OpenCASCADE asks now and then and stops what it does.
class OcctProgress : public Message_ProgressIndicator {
  DEFINE_STANDARD_RTTI_INLINE(OcctProgress, Message_ProgressIndicator)

 public:
  explicit OcctProgress(const LoadOptions& options);

  // What is started next takes the progress from `from` to `to`.
  Message_ProgressRange start(double from, double to);
  bool time_is_over() const { return std::chrono::steady_clock::now() > deadline_; }

 protected:
  Standard_Boolean UserBreak() override { return time_is_over(); }
  void Show(const Message_ProgressScope& scope, Standard_Boolean force) override;

 private:
  std::function<void(const char*, double)> report_;
  std::chrono::steady_clock::time_point deadline_;
  double from_ = 0, to_ = 0;
};

// What `work` returns, or one error with OpenCASCADE's own words when it throws or the library crashes in it.
// One caller at a time: OpenCASCADE keeps settings and messages in globals. A crash is turned into an error
// by OpenCASCADE's signal handlers, which are in place only meanwhile; what the broken step held is lost.
Diagnostics with_occt(const std::string& file, const std::function<Diagnostics()>& work);

}  // namespace gabarit
