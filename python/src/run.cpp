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

/// Whether the interpreter ends, and the thread that ends it, which alone may ask for the lock then.
std::atomic<bool> is_ending{false};
std::thread::id ending_thread;
/// How many threads ask for the lock.
std::atomic<int> asking{0};

/// Calls `ask`, which waits for the lock, unless the interpreter ends.
template <class Ask>
auto ask_for_lock(Ask ask) {
  ++asking;
  if (is_ending && std::this_thread::get_id() != ending_thread) {
    --asking;
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
  }
  const auto state = ask();
  --asking;
  return state;
}

/// The token of the computation that the main thread is in.
std::atomic<CancelToken*> interrupted{nullptr};

/// How many handlers may still set a token: a signal may come to any thread.
std::atomic<int> cancelling{0};

std::array<struct sigaction, watched_signals.size()> handlers_before;

/// Stops the computation, then does what the handler before does: that of Python notes the signal.
void stop_and_note(int signal_number, siginfo_t* information, void* context) {
  ++cancelling;
  if (CancelToken* const token = interrupted.load()) token->cancel();
  --cancelling;
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
  static PyObject* main_thread = nullptr;  // kept for ever; it is written with the lock held
  if (main_thread == nullptr)
    main_thread = nb::object(nb::module_::import_("threading").attr("main_thread")).release().ptr();
  return nb::cast<unsigned long>(nb::handle(main_thread)().attr("ident")) == PyThread_get_thread_ident();
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
  ~SignalGuard() { stop(); }

  /// From here on, signals do what they did before. None sets the token any more.
  void stop() {
    if (!is_set_) return;
    is_set_ = false;
    for (std::size_t i = 0; i < watched_signals.size(); ++i)
      if (is_replaced_[i]) set_back(watched_signals[i], handlers_before[i]);
    interrupted = before_;
    while (cancelling > 0) std::this_thread::yield();
  }

 private:
  /// A handler that somebody else has set meanwhile stays.
  static void set_back(int signal_number, const struct sigaction& before) {
    struct sigaction now;
    sigaction(signal_number, &before, &now);
    const bool is_ours = (now.sa_flags & SA_SIGINFO) != 0 && now.sa_sigaction == stop_and_note;
    if (!is_ours) sigaction(signal_number, &now, nullptr);
  }

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
    const LockHeld held;
    delete object;
  });
  return [kept](double fraction) {
    const LockHeld held;
    (*kept)(fraction);
  };
}

}  // namespace

LockReleased::~LockReleased() {
  ask_for_lock([this] {
    PyEval_RestoreThread(state_);
    return 0;
  });
}

LockHeld::LockHeld() : state_(ask_for_lock([] { return PyGILState_Ensure(); })) {}

void watch_for_the_end() {
  const nb::object end = nb::cpp_function([] {
    ending_thread = std::this_thread::get_id();
    is_ending = true;
    // Those who ask already get the lock: it is theirs as long as they are counted.
    PyThreadState* const state = PyEval_SaveThread();
    // A fork may have left a count without its thread: no longer than a second.
    for (int i = 0; asking > 0 && i < 1000; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    PyEval_RestoreThread(state);
  });
  nb::module_::import_("atexit").attr("register")(end);
}

struct Computation::State {
  explicit State(const Watch& watch) : cut_material(watch.cut_material), signals(token) {
    options.threads = watch.threads;
    if (cut_material) options.cut_material = &*cut_material;
    options.cancel = &token;
    options.progress = progress_of(watch.progress.object);
    if (!watch.timeout) return;
    if (!(*watch.timeout > 0)) throw std::invalid_argument("timeout: expected a positive number of seconds, or None");
    deadline.emplace(token, *watch.timeout);
  }

  CancelToken token;
  std::optional<Material> cut_material;
  Options options;
  SignalGuard signals;
  std::optional<Deadline> deadline;
};

Computation::Computation(const Watch& watch) : state_(std::make_unique<State>(watch)) {}
Computation::~Computation() = default;

const Options& Computation::options() const { return state_->options; }
Monitor Computation::monitor() const { return Monitor(&state_->token, &state_->options.progress); }

void Computation::stopped() {
  state_->signals.stop();  // what comes while a handler runs must not stop the second start
  state_->token.reset();   // before the time limit is looked at: one that passes from here on is not lost
  if (PyErr_CheckSignals() != 0) throw nb::python_error();
  if (state_->deadline && state_->deadline->is_passed()) {
    PyErr_SetString(PyExc_TimeoutError, "the computation was stopped at its time limit");
    throw nb::python_error();
  }
}

void Computation::run_aside(FunctionRef<void()> work) {
  std::atomic<bool> is_done = false;
  std::mutex mutex;
  std::condition_variable done;
  std::thread thread([&] {
    work();
    const std::lock_guard lock(mutex);
    is_done = true;
    done.notify_one();
  });
  bool is_raised = false;
  while (!is_done) {
    {
      const LockReleased released;
      std::unique_lock lock(mutex);
      done.wait_for(lock, std::chrono::milliseconds(20), [&] { return is_done.load(); });
    }
    if (is_raised || PyErr_CheckSignals() == 0) continue;
    is_raised = true;
    state_->token.cancel();
  }
  thread.join();
  if (is_raised) throw nb::python_error();
}

}  // namespace strata::python
