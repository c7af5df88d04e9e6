#pragma once
/// How a long computation is watched and stopped from outside.
#include <cstddef>

#include "strata/errors.h"
#include "strata/function.h"

namespace strata {

/// A request to stop. One thread computes, with `Options::cancel` or a Monitor pointing to the token; any other thread
/// calls `cancel`, and the computation throws Cancelled within milliseconds. One token may stop many computations.
/// Every member is thread-safe and lock-free, and may be called in a signal handler. A token is neither copied nor
/// moved: whoever computes holds a pointer to it, and it must outlive the computation.
class CancelToken {
 public:
  CancelToken() noexcept;
  CancelToken(const CancelToken&) = delete;
  CancelToken& operator=(const CancelToken&) = delete;

  void cancel() noexcept;  ///< asks to stop; more than once is as good as once
  void reset() noexcept;   ///< takes the request back, so that the token can be used again
  [[nodiscard]] bool is_cancelled() const noexcept;

 private:
  alignas(int) std::byte flag_[sizeof(int)];  // a std::atomic<bool>
};

/// Called with the fraction of the work that is done, from 0 to 1, never decreasing. Calls may come from any thread,
/// but never from two at once. What it throws ends the computation and reaches the caller.
using Progress = Function<void(double)>;

/// A token and a progress function together, either of which may be missing, as a parameter. Refers to both: they
/// must outlive it. Copying is O(1).
class Monitor {
 public:
  Monitor() = default;  ///< watches nothing
  explicit Monitor(const CancelToken* cancel, const Progress* progress = nullptr)
      : cancel_(cancel), progress_(progress) {}

  /// Throws Cancelled once the token is set. O(1). Thread-safe.
  void check() const {
    if (cancel_ != nullptr && cancel_->is_cancelled()) throw Cancelled("cancelled by the caller");
  }

  /// The token; null: there is none.
  [[nodiscard]] const CancelToken* token() const { return cancel_; }

  /// Reports how far the work is, from 0 to 1. To be called between stages, never from two threads at once.
  void report(double fraction) const {
    if (progress_ != nullptr && *progress_) (*progress_)(fraction);
  }

 private:
  const CancelToken* cancel_ = nullptr;
  const Progress* progress_ = nullptr;
};

}  // namespace strata
