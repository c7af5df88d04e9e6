#pragma once
/// How a long computation is run from Python: without the interpreter's lock, watched, and stopped by signals.
#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <strata/attributes.h>
#include <strata/function.h>
#include <strata/monitor.h>
#include <strata/options.h>

#include <exception>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "numbers.h"

namespace strata::python {

namespace nb = nanobind;

/// None, True (a bar of tqdm) or a callable that takes the fraction done.
struct ProgressOption {
  nb::object object = nb::none();
};

/// The keyword arguments `threads`, `progress` and `timeout` of every long computation, and `cut_material` of some.
struct Watch {
  unsigned threads = 0;
  ProgressOption progress;
  std::optional<double> timeout;
  std::optional<Material> cut_material = {};
};

/// While it lives, the interpreter's lock is released. Once the interpreter ends, other threads than its own must not
/// ask for the lock again: they would be ended, and their destructors not survive that. They wait for the end of the
/// process.
class LockReleased {
 public:
  LockReleased() : state_(PyEval_SaveThread()) {}
  LockReleased(const LockReleased&) = delete;
  LockReleased& operator=(const LockReleased&) = delete;
  ~LockReleased();

 private:
  PyThreadState* state_;
};

/// While it lives, the lock is held, by a thread of any kind.
class LockHeld {
 public:
  LockHeld();
  LockHeld(const LockHeld&) = delete;
  LockHeld& operator=(const LockHeld&) = delete;
  ~LockHeld() { PyGILState_Release(state_); }

 private:
  PyGILState_STATE state_;
};

/// To be called once, when the module is made.
void watch_for_the_end();

/// One computation: while it lives, signals that Python handles and the end of the time limit stop what is given its
/// options. To be made and destroyed with the interpreter's lock held.
class Computation {
 public:
  /// Throws std::invalid_argument for a timeout that is not positive.
  explicit Computation(const Watch& watch);
  Computation(const Computation&) = delete;
  Computation& operator=(const Computation&) = delete;
  ~Computation();

  [[nodiscard]] const Options& options() const;
  [[nodiscard]] Monitor monitor() const;

  /// To be called after Cancelled, with the lock held: throws what the signal's handler raised, or TimeoutError.
  /// Returns where a handler decided that the program goes on: the computation is to be started anew, aside.
  void stopped();

  /// After stopped(): runs `work`, which throws nothing, in another thread, and the handlers of signals in this one
  /// meanwhile. With the lock held. Signals alone no longer stop the computation, but what their handlers raise does,
  /// and is thrown.
  void run_aside(FunctionRef<void()> work);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The result of compute(const Computation&), which runs without the interpreter's lock. What it computes must not
/// depend on objects of Python.
template <class F>
auto run(const Watch& watch, F&& compute) {
  using Result = std::invoke_result_t<F&, const Computation&>;
  Computation computation(watch);
  try {
    const LockReleased released;
    return compute(std::as_const(computation));
  } catch (const Cancelled&) {
  }
  computation.stopped();
  // Rare: a handler let the program go on. More signals may come, so that starting anew at each might never end.
  std::optional<Result> result;
  std::exception_ptr error;
  computation.run_aside([&] {
    try {
      result.emplace(compute(std::as_const(computation)));
    } catch (...) {
      error = std::current_exception();
    }
  });
  if (result) return std::move(*result);
  try {
    std::rethrow_exception(error);
  } catch (const Cancelled&) {
    computation.stopped();  // the time limit
    throw;
  }
}

/// The same for what can neither be watched nor stopped.
template <class F>
auto run(F&& compute) {
  const LockReleased released;
  return compute();
}

/// The keyword arguments in a signature.
#define STRATA_WATCH_ARGUMENTS                                                \
  nanobind::arg("threads") = 0, nanobind::arg("progress") = nanobind::none(), \
  nanobind::arg("timeout") = nanobind::none()

}  // namespace strata::python

namespace nanobind::detail {

STRATA_ARGUMENT(strata::python::ProgressOption, "Progress");

}  // namespace nanobind::detail
