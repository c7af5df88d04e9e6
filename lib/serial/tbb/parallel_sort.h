#pragma once
#include <algorithm>
#include <functional>

namespace tbb {

template <class Iterator, class Less = std::less<>>
void parallel_sort(Iterator first, Iterator last, const Less& less = {}) {
  std::sort(first, last, less);
}

template <class Items>
void parallel_sort(Items& items) {
  std::sort(items.begin(), items.end());
}

template <class Items, class Less>
requires requires(Items& items) { items.begin(); }
void parallel_sort(Items& items, const Less& less) { std::sort(items.begin(), items.end(), less); }

}  // namespace tbb
