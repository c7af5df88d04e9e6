#pragma once
#include <atomic>
#include <functional>

#include "strata/mesh/defect.h"

namespace strata {

/// Lets a long computation be cancelled and watched from outside. Holds references to what the caller owns.
class Monitor {
 public:
  Monitor() = default;
  explicit Monitor(const std::atomic<bool>* cancel, const std::function<void(double)>* progress = nullptr)
      : cancel_(cancel), progress_(progress) {}

  /// Throws Cancelled once the caller has asked for it.
  void check() const {
    if (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) throw Cancelled("cancelled by the caller");
  }

  /// Tells how far the work is, 0 to 1. To be called between stages, never from two threads at once.
  void report(double fraction) const {
    if (progress_ != nullptr && *progress_) (*progress_)(fraction);
  }

 private:
  const std::atomic<bool>* cancel_ = nullptr;
  const std::function<void(double)>* progress_ = nullptr;
};

}  // namespace strata
