#pragma once
#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

namespace tbb {

/// One object of the one thread, made when it is first asked for.
template <class T>
class enumerable_thread_specific {
 public:
  enumerable_thread_specific() : make_([] { return T(); }) {}
  template <class Make>
  requires std::invocable<const Make&>
  explicit enumerable_thread_specific(Make make) : make_(std::move(make)) {}

  [[nodiscard]] T& local() {
    if (!own_) own_.reset(new T(make_()));
    return *own_;
  }
  [[nodiscard]] std::size_t size() const { return own_ ? 1 : 0; }
  [[nodiscard]] T* begin() { return own_.get(); }
  [[nodiscard]] T* end() { return own_.get() + size(); }
  [[nodiscard]] const T* begin() const { return own_.get(); }
  [[nodiscard]] const T* end() const { return own_.get() + size(); }

 private:
  std::function<T()> make_;
  std::unique_ptr<T> own_;
};

}  // namespace tbb
