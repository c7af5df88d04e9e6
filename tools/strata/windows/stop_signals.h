#pragma once
#include "common/watch.h"

/// Ctrl-C as a token, for a batch. One per process, in place of a Watch.
class StopSignals {
 public:
  StopSignals() : watch_(0) { watch_.hold(); }
  [[nodiscard]] const strata::CancelToken& token() const { return watch_.token(); }

 private:
  Watch watch_;
};
