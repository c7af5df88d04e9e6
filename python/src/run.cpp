#include "run.h"

#include <signal.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace strata::python {

namespace {

/// The signals that end a program, and may have handlers in Python.
constexpr std::array watched_signals{SIGINT, SIGTERM, SIGALRM};

/// The token of the computation that the main thread is in.
std::atomic<CancelToken*> interrupted{nullptr};

std::array<struct sigaction, watched_signals.size()> handlers_before;

/// Stops the computation, then does what the handler before does: that of Python notes the signal.
void stop_and_note(int signal_number, siginfo_t* information, void* context) {
  if (CancelToken* const token = interrupted.load()) token->cancel();
  for (std::size_t i = 0; i < watched_signals.size(); ++i)
    if (watched_signals[i] == signal_number) {
      const struct sigaction& before = handlers_before[i];
      if ((before.sa_flags & SA_SIGINFO) != 0)
        before.sa_sigaction(signal_number, information, context);
      else if (before.sa_handler != SIG_DFL && before.sa_handler != SIG_IGN)
        before.sa_handler(signal_number);
    }
}

bool has_handler(const struct sigaction& action) {
  return (action.sa_flags & SA_SIGINFO) != 0 || (action.sa_handler != SIG_DFL && action.sa_handler != SIG_IGN);
}

/// Python runs handlers of signals in its main thread only.
bool is_main_thread() {
  const nb::module_ threading = nb::module_::import_("threading");
  return threading.attr("get_ident")().equal(threading.attr("main_thread")().attr("ident"));
}

/// While it lives, signals that have handlers stop a computation of the main thread.
class SignalGuard {
 public:
  explicit SignalGuard(CancelToken& token) {
    if (!is_main_thread()) return;
    before_ = interrupted.exchange(&token);
    is_set_ = true;
    if (before_ != nullptr) return;  // within another computation, whose handlers stay
    for (std::size_t i = 0; i < watched_signals.size(); ++i) {
      sigaction(watched_signals[i], nullptr, &handlers_before[i]);
      is_replaced_[i] = has_handler(handlers_before[i]);
      if (!is_replaced_[i]) continue;
      struct sigaction ours = handlers_before[i];
      ours.sa_flags |= SA_SIGINFO;
      ours.sa_sigaction = stop_and_note;
      sigaction(watched_signals[i], &ours, nullptr);
    }
  }
  SignalGuard(const SignalGuard&) = delete;
  SignalGuard& operator=(const SignalGuard&) = delete;
  ~SignalGuard() {
    if (!is_set_) return;
    for (std::size_t i = 0; i < watched_signals.size(); ++i)
      if (is_replaced_[i]) sigaction(watched_signals[i], &handlers_before[i], nullptr);
    interrupted = before_;
  }

 private:
  CancelToken* before_ = nullptr;
  bool is_set_ = false;
  std::array<bool, watched_signals.size()> is_replaced_{};
};

/// Sets a token after some time, unless it is destroyed before.
class Deadline {
 public:
  Deadline(CancelToken& token, double seconds)
      : thread_([this, &token, seconds] {
          std::unique_lock lock(mutex_);
          // Longer than a year is for ever: durations are counted in 64 bits.
          const std::chrono::duration<double> limit(std::min(seconds, 3e7));
          if (over_.wait_for(lock, limit, [this] { return is_over_; })) return;
          is_passed_ = true;
          token.cancel();
        }) {}
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;
  ~Deadline() {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
    }
    over_.notify_one();
    thread_.join();
  }

  [[nodiscard]] bool is_passed() const { return is_passed_; }

 private:
  std::mutex mutex_;
  std::condition_variable over_;
  bool is_over_ = false;
  std::atomic<bool> is_passed_ = false;
  std::thread thread_;  // the last member: it uses the others
};

/// The function that is told how far a computation is.
Progress progress_of(const nb::object& progress) {
  if (progress.is_none() || progress.is(nb::handle(Py_False))) return {};
  nb::object callable = progress;
  if (progress.is(nb::handle(Py_True))) callable = nb::module_::import_("strata_csg._progress").attr("bar")();
  if (!nb::hasattr(callable, "__call__"))
    throw nb::type_error("progress: expected None, True, or a callable that takes the fraction done");
  // The last copy may go in any thread.
  const std::shared_ptr<nb::object> kept(new nb::object(std::move(callable)), [](nb::object* object) {
    const nb::gil_scoped_acquire acquired;
    delete object;
  });
  return [kept](double fraction) {
    const nb::gil_scoped_acquire acquired;
    (*kept)(fraction);
  };
}

}  // namespace

struct Computation::State {
  explicit State(const Watch& watch) : signals(token) {
    options.threads = watch.threads;
    options.cancel = &token;
    options.progress = progress_of(watch.progress.object);
    if (!watch.timeout) return;
    if (!(*watch.timeout > 0)) throw std::invalid_argument("timeout: expected a positive number of seconds, or None");
    deadline.emplace(token, *watch.timeout);
  }

  CancelToken token;
  Options options;
  SignalGuard signals;
  std::optional<Deadline> deadline;
};

Computation::Computation(const Watch& watch) : state_(std::make_unique<State>(watch)) {}
Computation::~Computation() = default;

const Options& Computation::options() const { return state_->options; }
Monitor Computation::monitor() const { return Monitor(&state_->token, &state_->options.progress); }

void Computation::stopped() {
  state_->token.reset();  // first: a time limit that passes from here on is not lost
  if (PyErr_CheckSignals() != 0) throw nb::python_error();
  if (state_->deadline && state_->deadline->is_passed()) {
    PyErr_SetString(PyExc_TimeoutError, "the computation was stopped at its time limit");
    throw nb::python_error();
  }
}

}  // namespace strata::python
