#pragma once
#include <cstddef>
#include <vector>

#include "core/system/memory.h"

namespace strata {

using system::prefer_huge_pages;

/// Resizes an empty vector, with huge pages if it is large. Most of the cost of writing a large array once is the first
/// access to its pages.
template <class T>
void resize_fresh(std::vector<T>& v, std::size_t size, const T& value = {}) {
  v.reserve(size);
  prefer_huge_pages(v.data(), size * sizeof(T));
  v.resize(size, value);
}

}  // namespace strata
