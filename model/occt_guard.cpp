#include "model/occt_guard.h"

#include <array>
#include <csignal>
#include <mutex>

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <OSD.hxx>
#include <Standard_ErrorHandler.hxx>
#include <fmt/format.h>

#include "model/text_encoding.h"

namespace gabarit {
namespace {

// OpenCASCADE's printers write on standard output, where the program's results go.
class QuietMessenger {
 public:
  QuietMessenger() : printers_(Message::DefaultMessenger()->Printers()) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
  }
  ~QuietMessenger() { Message::DefaultMessenger()->ChangePrinters() = printers_; }
  QuietMessenger(const QuietMessenger&) = delete;
  QuietMessenger& operator=(const QuietMessenger&) = delete;

 private:
  Message_SequenceOfPrinters printers_;
};

class SignalsAsExceptions {
 public:
  SignalsAsExceptions() {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], nullptr, &before_[i]);
    OSD::SetSignal(OSD_SignalMode_Set, Standard_False);
    // A user who wants to stop the program still can.
    for (std::size_t i = crashes; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
  }
  ~SignalsAsExceptions() {
    for (std::size_t i = 0; i < crashes; ++i) sigaction(signals[i], &before_[i], nullptr);
  }
  SignalsAsExceptions(const SignalsAsExceptions&) = delete;
  SignalsAsExceptions& operator=(const SignalsAsExceptions&) = delete;

 private:
  // Those that OSD::SetSignal takes over, crashes first. A bus error comes from mapped files, which are not
  // OpenCASCADE's.
  static constexpr std::size_t crashes = 4;
  static constexpr std::array signals{SIGSEGV, SIGILL, SIGFPE,  SIGSYS, SIGBUS,
                                      SIGHUP,  SIGINT, SIGQUIT, SIGTERM};
  std::array<struct sigaction, signals.size()> before_{};
};

Diagnostics failure(const std::string& file, const std::string& words) {
  return {{.file = file,
           .message =
               fmt::format("OpenCASCADE could not read it ({}); it is damaged or uses what version 7.6 does "
                           "not know: export it again, or as STEP AP214",
                           words.empty() ? "no reason given" : valid_utf8(words))}};
}

std::string words_of(const Standard_Failure& error) {
  const std::string text = error.GetMessageString() == nullptr ? "" : error.GetMessageString();
  const std::string kind = error.DynamicType()->Name();
  return text.empty() ? kind : kind + ": " + text;
}

// A frame of its own: the long jump of a signal lands in it.
Diagnostics caught(const std::string& file, const std::function<Diagnostics()>& work) {
  try {
    OCC_CATCH_SIGNALS
    return work();
  } catch (const Standard_Failure& error) {
    return failure(file, words_of(error));
  } catch (const std::exception& error) {
    return failure(file, error.what());
  }
}

}  // namespace

OcctProgress::OcctProgress(const LoadOptions& options)
    : report_(options.progress),
      deadline_(std::chrono::steady_clock::now() +
                std::chrono::milliseconds(static_cast<std::int64_t>(options.time_limit * 1e3))) {}

Message_ProgressRange OcctProgress::start(double from, double to) {
  from_ = from, to_ = to;
  return Start();
}

void OcctProgress::Show(const Message_ProgressScope&, Standard_Boolean) {
  if (report_) report_("reading", from_ + (to_ - from_) * GetPosition());
}

Diagnostics with_occt(const std::string& file, const std::function<Diagnostics()>& work) {
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  const QuietMessenger quiet;
  const SignalsAsExceptions signals;
  return caught(file, work);
}

}  // namespace gabarit
