/// Signals belong to the main thread.
#pragma once

#include <csignal>

namespace sbgc::tools {

/// Blocks all signals for the threads that start meanwhile: the others handle them, and a write
/// without a reader is only an error.
class WithoutSignals {
 public:
  WithoutSignals() {
    sigset_t all{};
    sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &previous_);
  }
  WithoutSignals(const WithoutSignals&) = delete;
  WithoutSignals& operator=(const WithoutSignals&) = delete;
  ~WithoutSignals() { ::pthread_sigmask(SIG_SETMASK, &previous_, nullptr); }

 private:
  sigset_t previous_{};
};

}  // namespace sbgc::tools
