#include "common/watch.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <system_error>

#include "common/exit_code.h"
#include "strata/errors.h"

namespace {

// A signal handler may do little more than write to a pipe. Its ends live as long as the process.
int pipe_ends[2] = {-1, -1};
constexpr char by_signal = 's';
constexpr char by_destructor = 'd';
constexpr auto patience = std::chrono::seconds(2);  // with an engine that was asked to stop

void send(char why) {
  const int error = errno;
  [[maybe_unused]] const auto written = write(pipe_ends[1], &why, 1);
  errno = error;
}

// The handler serves once: a second Ctrl-C ends the process the hard way.
void handle_signals() {
  struct sigaction action = {};
  action.sa_handler = [](int) { send(by_signal); };
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is a write error like any other
  std::signal(SIGXFSZ, SIG_IGN);  // and so is a file that has its largest size
}

int milliseconds_until(std::chrono::steady_clock::time_point end) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now()).count();
  return static_cast<int>(std::clamp<long long>(left, 0, 1'000'000'000));
}

[[noreturn]] void leave(const std::string& reason) {
  fmt::print(stderr, "strata: {}; no result was written\n", reason);
  std::_Exit(static_cast<int>(ExitCode::stopped));
}

}  // namespace

Watch::Watch(double seconds) : seconds_(std::min(seconds, 1e9)) {
  if (pipe_ends[0] < 0 && pipe(pipe_ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  for (const int end : pipe_ends) fcntl(end, F_SETFD, FD_CLOEXEC);
  handle_signals();
  thread_ = std::thread([this] { run(); });
}

Watch::~Watch() {
  send(by_destructor);
  thread_.join();
}

void Watch::on_stop(OnStop action) {
  const std::lock_guard lock(mutex_);
  if (stopped_.is_cancelled()) throw strata::Cancelled(reason_);
  action_ = action;
}

void Watch::hold() {
  const std::lock_guard lock(mutex_);
  action_ = OnStop::hold;
}

std::string Watch::reason() {
  const std::lock_guard lock(mutex_);
  return reason_;
}

void Watch::run() {
  using Seconds = std::chrono::duration<double>;
  bool timed = seconds_ > 0;
  auto end = std::chrono::steady_clock::now() + std::chrono::ceil<std::chrono::milliseconds>(Seconds(seconds_));
  pollfd wake = {pipe_ends[0], POLLIN, 0};
  while (true) {
    const int ready = poll(&wake, 1, timed ? milliseconds_until(end) : -1);
    char why = by_destructor;
    if (ready > 0) {
      if (read(pipe_ends[0], &why, 1) != 1 || why == by_destructor) return;
      stop("interrupted");
    } else if (ready == 0 && std::chrono::steady_clock::now() >= end) {
      if (stopped_.is_cancelled()) leave_if_still_asked();
      stop(fmt::format("time limit of {} s reached", seconds_));
    } else {
      continue;  // woken early
    }
    timed = stopped_.is_cancelled();
    end = std::chrono::steady_clock::now() + patience;
  }
}

void Watch::stop(const std::string& reason) {
  const std::lock_guard lock(mutex_);
  if (stopped_.is_cancelled() || action_ == OnStop::finish) return;
  if (action_ == OnStop::leave) leave(reason);
  reason_ = reason;
  stopped_.cancel();
}

void Watch::leave_if_still_asked() {
  const std::lock_guard lock(mutex_);
  if (action_ == OnStop::ask) leave(reason_);
}
