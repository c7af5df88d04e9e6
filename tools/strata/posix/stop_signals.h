#pragma once
#include <csignal>

#include "strata/monitor.h"

/// SIGINT and SIGTERM as a token, for a process that has no other threads: they are noticed while it waits. One per
/// process, in place of a Watch.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  [[nodiscard]] const strata::CancelToken& token() const;
  /// From here on signals come only with this mask, as that of ppoll.
  void hold();
  [[nodiscard]] const sigset_t& mask() const { return before_; }

 private:
  sigset_t before_ = {};
  struct sigaction interrupt_ = {}, terminate_ = {}, pipe_ = {};
};
