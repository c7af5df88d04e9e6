#pragma once
/// Callables as values and as parameters: what std::function is for Strata, without the 16,000 lines of <functional>.
///
/// Both types take whatever std::function takes but pointers to members: lambdas, function objects, functions,
/// std::function itself.
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "strata/shared.h"

namespace strata {

namespace detail {

/// F can be called with A... and gives what converts to R (anything, if R is void).
template <class F, class R, class... A>
concept CallableAs = std::is_invocable_r_v<R, F&, A...> && !std::is_member_pointer_v<std::remove_cvref_t<F>>;

/// A pointer to a function, or a wrapper like std::function, that may hold none.
template <class F>
concept MayBeNone = !std::is_function_v<std::remove_reference_t<F>> && !std::is_empty_v<std::decay_t<F>> &&
                    requires(const std::decay_t<F>& f) {
  f == nullptr;
};

template <class R, class F, class... A>
R call(F& f, A&&... arguments) {
  if constexpr (std::is_void_v<R>)
    static_cast<void>(f(std::forward<A>(arguments)...));
  else
    return f(std::forward<A>(arguments)...);
}

}  // namespace detail

template <class Signature>
class Function;
template <class Signature>
class FunctionRef;

/// A callable that is kept, or none. Copies share the callable with its state: std::function would copy it.
/// Copying is O(1) and does not throw; making one from a callable allocates once. Calling is as thread-safe as the
/// callable.
template <class R, class... A>
class Function<R(A...)> {
 public:
  Function() noexcept = default;        ///< none
  Function(std::nullptr_t) noexcept {}  // NOLINT(google-explicit-constructor): none
  /// Of a null pointer or an empty std::function, none.
  template <class F>
  requires(!std::same_as<std::remove_cvref_t<F>, Function> && detail::CallableAs<std::decay_t<F>, R, A...>)
      Function(F&& f) {  // NOLINT(google-explicit-constructor): a callable is a function
    if constexpr (detail::MayBeNone<F>)
      if (f == nullptr) return;
    target_ = Shared<Callable<std::decay_t<F>>>::make(std::forward<F>(f));
  }

  [[nodiscard]] explicit operator bool() const noexcept { return static_cast<bool>(target_); }
  /// Requires that there is a callable.
  R operator()(A... arguments) const { return target_->call(std::forward<A>(arguments)...); }

 private:
  struct Target {
    virtual ~Target() = default;
    virtual R call(A... arguments) const = 0;
  };
  template <class F>
  struct Callable final : Target {
    explicit Callable(F f) : function(std::move(f)) {}
    R call(A... arguments) const override { return detail::call<R>(function, std::forward<A>(arguments)...); }
    mutable F function;  ///< a callable may change its own state
  };
  Shared<Target> target_;
};

/// A callable that somebody else owns, as a parameter: used during the call that it is given to, and not kept. Nothing
/// is allocated. Calling is as thread-safe as the callable.
template <class R, class... A>
class FunctionRef<R(A...)> {
 public:
  template <class F>
  requires(!std::same_as<std::remove_cvref_t<F>, FunctionRef> &&
           detail::CallableAs<std::remove_reference_t<F>, R, A...>) FunctionRef(F&& f)
  noexcept {  // NOLINT(google-explicit-constructor): a callable is a function
    using Target = std::remove_reference_t<F>;
    if constexpr (std::is_function_v<Target>) {
      target_.function = reinterpret_cast<void (*)()>(&f);
      call_ = [](Pointer target, A... arguments) -> R {
        return detail::call<R>(*reinterpret_cast<Target*>(target.function), std::forward<A>(arguments)...);
      };
    } else {
      target_.object = const_cast<void*>(static_cast<const void*>(&f));
      call_ = [](Pointer target, A... arguments) -> R {
        return detail::call<R>(*static_cast<Target*>(target.object), std::forward<A>(arguments)...);
      };
    }
  }

  R operator()(A... arguments) const { return call_(target_, std::forward<A>(arguments)...); }

 private:
  union Pointer {
    void* object;
    void (*function)();
  };
  Pointer target_{};
  R (*call_)(Pointer, A...) = nullptr;
};

}  // namespace strata
