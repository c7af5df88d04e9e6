#pragma once
#include <cstddef>
#include <vector>

namespace strata {

/// Asks the system to back a large piece of fresh memory with huge pages. A hint: nothing depends on it.
void prefer_huge_pages(void* memory, std::size_t bytes);

/// An empty vector resized, its memory on huge pages if it is large: most of the cost of writing a large array once is
/// that its pages are touched for the first time.
template <class T>
void resize_fresh(std::vector<T>& v, std::size_t size, const T& value = {}) {
  v.reserve(size);
  prefer_huge_pages(v.data(), size * sizeof(T));
  v.resize(size, value);
}

}  // namespace strata
