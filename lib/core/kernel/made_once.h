#pragma once
#include <atomic>
#include <cstddef>
#include <memory>

namespace strata {

/// Values that are made when they are first asked for. Threads that ask at the same time may make one twice; all get
/// the same one.
template <class T>
class MadeOnce {
 public:
  explicit MadeOnce(std::size_t count)
      : count_(count), values_(std::make_unique<std::atomic<const T*>[]>(count)) {}  // NOLINT(*-avoid-c-arrays)
  MadeOnce(const MadeOnce&) = delete;
  MadeOnce(MadeOnce&&) = delete;
  MadeOnce& operator=(const MadeOnce&) = delete;
  MadeOnce& operator=(MadeOnce&&) = delete;
  ~MadeOnce() {
    for (std::size_t i = 0; i < count_; ++i) delete values_[i].load(std::memory_order_relaxed);
  }

  /// Value `i`; `make()` returns it, and must return equal values for equal `i`.
  template <class Make>
  [[nodiscard]] const T& get(std::size_t i, const Make& make) const {
    std::atomic<const T*>& value = values_[i];
    if (const T* known = value.load(std::memory_order_acquire)) return *known;
    auto made = std::make_unique<const T>(make());
    const T* other = nullptr;
    const bool is_first =
        value.compare_exchange_strong(other, made.get(), std::memory_order_acq_rel, std::memory_order_acquire);
    return is_first ? *made.release() : *other;
  }

 private:
  std::size_t count_;
  std::unique_ptr<std::atomic<const T*>[]> values_;  // NOLINT(*-avoid-c-arrays): atomics cannot be moved
};

}  // namespace strata
