#pragma once
#include <algorithm>
#include <cstddef>
#include <memory_resource>
#include <span>
#include <type_traits>

namespace strata {

/// Memory for many small arrays that live as long as the pool: allocated in order, released together. For one thread at
/// a time.
class Pool {
 public:
  /// A copy of an array, in the pool.
  template <class Range>
  [[nodiscard]] auto keep(const Range& range) {
    using T = std::remove_cv_t<std::remove_reference_t<decltype(*std::data(range))>>;
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
    if (std::size(range) == 0) return std::span<T>();
    T* const to = static_cast<T*>(memory_.allocate(std::size(range) * sizeof(T), alignof(T)));
    std::uninitialized_copy(std::begin(range), std::end(range), to);
    return std::span<T>(to, std::size(range));
  }

 private:
  std::pmr::monotonic_buffer_resource memory_{1 << 12};
};

}  // namespace strata
