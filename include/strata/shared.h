#pragma once
/// A handle to an immutable value that copies of the handle share. It is what std::shared_ptr<const T> is, without the
/// 22,000 lines of <memory>. The value types of Strata (Solid, Expression, Scene, ...) hold one; most callers never see
/// it.
#include <concepts>
#include <cstddef>
#include <utility>

namespace strata {

namespace detail {

/// A value that counts its handles. The count is atomic; it lives in the library, so that <atomic> is not needed here.
class Counted {
 public:
  Counted() noexcept;
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  virtual ~Counted();

  void retain() const noexcept;   ///< one handle more
  void release() const noexcept;  ///< one handle less; deletes the value with the last one
  [[nodiscard]] bool has_one_handle() const noexcept;

 private:
  alignas(std::size_t) mutable std::byte uses_[sizeof(std::size_t)];
};

template <class T>
struct Holder final : Counted {
  template <class... Arguments>
  explicit Holder(Arguments&&... arguments) : value(std::forward<Arguments>(arguments)...) {}
  T value;
};

}  // namespace detail

/// A handle to a shared, immutable T, or to nothing. T may be incomplete where no value is made.
/// Copying is O(1) and does not throw. Different handles may be used by different threads at once, also when they share
/// the value; one handle may be read by many threads.
template <class T>
class Shared {
 public:
  Shared() noexcept = default;  ///< to nothing
  /// A new value, made from these arguments.
  template <class... Arguments>
  [[nodiscard]] static Shared make(Arguments&&... arguments) {
    const auto* const holder = new detail::Holder<T>(std::forward<Arguments>(arguments)...);
    Shared shared;
    shared.value_ = &holder->value;
    shared.owner_ = holder;
    return shared;
  }
  /// A value as one of its base classes.
  template <class U>
  requires std::convertible_to<const U*, const T*> Shared(Shared<U> other)
  noexcept  // NOLINT(google-explicit-constructor): as pointers are converted
      : value_(other.value_), owner_(std::exchange(other.owner_, nullptr)) {}
  Shared(const Shared& other) noexcept : value_(other.value_), owner_(other.owner_) {
    if (owner_ != nullptr) owner_->retain();
  }
  Shared(Shared&& other) noexcept
      : value_(std::exchange(other.value_, nullptr)), owner_(std::exchange(other.owner_, nullptr)) {}
  Shared& operator=(Shared other) noexcept {
    std::swap(value_, other.value_);
    std::swap(owner_, other.owner_);
    return *this;
  }
  ~Shared() {
    if (owner_ != nullptr) owner_->release();
  }

  [[nodiscard]] const T& operator*() const noexcept { return *value_; }  ///< requires that there is a value
  [[nodiscard]] const T* operator->() const noexcept { return value_; }
  [[nodiscard]] const T* get() const noexcept { return value_; }  ///< null for nothing
  [[nodiscard]] explicit operator bool() const noexcept { return value_ != nullptr; }
  /// True when no other handle shares the value.
  [[nodiscard]] bool is_only() const noexcept { return owner_ != nullptr && owner_->has_one_handle(); }

  /// Equal when both share one value; values are not compared.
  friend bool operator==(const Shared& a, const Shared& b) noexcept { return a.value_ == b.value_; }

 private:
  template <class U>
  friend class Shared;

  const T* value_ = nullptr;
  const detail::Counted* owner_ = nullptr;
};

}  // namespace strata
