#pragma once
#include <atomic>

#include "strata/mesh/defect.h"

namespace strata {

/// Lets a long computation be cancelled from outside. Cheap to copy and to ask.
class Monitor {
 public:
  Monitor() = default;
  explicit Monitor(const std::atomic<bool>* cancel) : cancel_(cancel) {}

  /// Throws Cancelled once the caller has asked for it.
  void check() const {
    if (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) throw Cancelled("cancelled by the caller");
  }

 private:
  const std::atomic<bool>* cancel_ = nullptr;
};

}  // namespace strata
