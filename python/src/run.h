#pragma once
/// How a long computation is run from Python: without the interpreter's lock, watched, and stopped by signals.
#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <strata/monitor.h>
#include <strata/options.h>

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

/// The keyword arguments `threads`, `progress` and `timeout` of every long computation.
struct Watch {
  unsigned threads = 0;
  ProgressOption progress;
  std::optional<double> timeout;
};

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
  /// Returns where a handler decided that the program goes on: the computation is to be started anew.
  void stopped();

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
  for (;;) {
    try {
      const nb::gil_scoped_release released;
      if constexpr (std::is_void_v<Result>) {
        compute(std::as_const(computation));
        return;
      } else {
        return compute(std::as_const(computation));
      }
    } catch (const Cancelled&) {
    }
    computation.stopped();
  }
}

/// The same for what can neither be watched nor stopped.
template <class F>
auto run(F&& compute) {
  const nb::gil_scoped_release released;
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
