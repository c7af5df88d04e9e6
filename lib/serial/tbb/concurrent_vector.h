#pragma once
#include <deque>
#include <iterator>
#include <utility>

namespace tbb {

/// A list whose items stay where they are when it grows.
template <class T>
class concurrent_vector : public std::deque<T> {
 public:
  typename std::deque<T>::iterator push_back(T item) {
    std::deque<T>::push_back(std::move(item));
    return std::prev(this->end());
  }
};

}  // namespace tbb
