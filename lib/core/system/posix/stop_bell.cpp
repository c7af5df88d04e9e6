#include "core/system/stop_bell.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <system_error>

namespace strata::system {
namespace {

// A signal handler may do little more than write to a pipe. Its ends live as long as the process.
int pipe_ends[2] = {-1, -1};

void send(StopBell::Why why) {
  const int error = errno;
  const char byte = static_cast<char>(why);
  [[maybe_unused]] const auto written = ::write(pipe_ends[1], &byte, 1);
  errno = error;
}

// The handler serves once: a second Ctrl-C ends the process the hard way.
void handle_signals() {
  struct sigaction action = {};
  action.sa_handler = [](int) { send(StopBell::Why::stop); };
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace

StopBell::StopBell() {
  if (pipe_ends[0] < 0 && ::pipe(pipe_ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  for (const int end : pipe_ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  handle_signals();
}

void StopBell::ring() { send(Why::owner); }

std::optional<StopBell::Why> StopBell::wait(std::optional<std::chrono::milliseconds> time) {
  pollfd wake = {pipe_ends[0], POLLIN, 0};
  const int milliseconds = time ? static_cast<int>(std::clamp<long long>(time->count(), 0, 1'000'000'000)) : -1;
  if (::poll(&wake, 1, milliseconds) <= 0) return std::nullopt;
  char why = 0;
  if (::read(pipe_ends[0], &why, 1) != 1) return Why::owner;
  return static_cast<Why>(why);
}

}  // namespace strata::system
