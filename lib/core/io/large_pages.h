#pragma once
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace strata::io {

/// Asks for large pages behind memory that is about to be filled: faults of small pages take as long as filling them.
/// A hint: where it is not taken, nothing changes but the time.
inline void prefer_large_pages(void* first, std::size_t bytes) {
  constexpr std::size_t worthwhile = std::size_t{1} << 22;
  if (bytes < worthwhile) return;
#ifdef MADV_HUGEPAGE
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const auto from = reinterpret_cast<std::uintptr_t>(first) / page * page;
  ::madvise(reinterpret_cast<void*>(from), reinterpret_cast<std::uintptr_t>(first) + bytes - from, MADV_HUGEPAGE);
#else
  static_cast<void>(first);
#endif
}

/// Makes an empty vector `size` items long.
template <class T>
void resize_in_large_pages(std::vector<T>& items, std::size_t size) {
  items.reserve(size);
  prefer_large_pages(items.data(), size * sizeof(T));
  items.resize(size);
}

}  // namespace strata::io
