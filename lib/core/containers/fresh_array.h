#pragma once
#include <cstddef>
#include <memory>
#include <type_traits>

#include "core/containers/huge_pages.h"

namespace strata {

/// A large array that is written before it is read: its memory is not touched when it is made, so that the threads that
/// write it also have its pages made. With huge pages if it is large.
template <class T>
class FreshArray {
  static_assert(std::is_trivially_default_constructible_v<T> && std::is_trivially_destructible_v<T>);

 public:
  FreshArray() = default;
  explicit FreshArray(std::size_t size) : items_(std::make_unique_for_overwrite<T[]>(size)), size_(size) {
    prefer_huge_pages(items_.get(), size * sizeof(T));
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] T& operator[](std::size_t i) { return items_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return items_[i]; }
  [[nodiscard]] T* begin() { return items_.get(); }
  [[nodiscard]] T* end() { return items_.get() + size_; }
  [[nodiscard]] const T* begin() const { return items_.get(); }
  [[nodiscard]] const T* end() const { return items_.get() + size_; }

 private:
  std::unique_ptr<T[]> items_;
  std::size_t size_ = 0;
};

}  // namespace strata
