#include "core/system/forked_call.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <system_error>

#include "core/system/streams.h"

namespace strata::system {
namespace {

/// Programs that another thread starts at the same time do not have its ends, where the system can see to it.
int make_pipe(int* ends) {
#if defined(__linux__)
  return ::pipe2(ends, O_CLOEXEC);
#else
  if (::pipe(ends) != 0) return -1;
  for (const int end : {ends[0], ends[1]}) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  return 0;
#endif
}

/// Bytes of address space that this process has; 0 where the system does not say.
std::uint64_t address_space() {
  std::ifstream statm("/proc/self/statm");
  std::uint64_t pages = 0;
  statm >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void limit(int resource, std::uint64_t value) {
  rlimit both{};
  if (::getrlimit(static_cast<__rlimit_resource_t>(resource), &both) != 0) return;
  both.rlim_cur = std::min<rlim_t>(value, both.rlim_max);
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

/// Handlers of this process are not for its child, which ends by what it is sent.
void forget_handlers() {
  for (const int signal : {SIGINT, SIGTERM, SIGALRM, SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGXCPU, SIGPIPE})
    std::signal(signal, SIG_DFL);
}

/// What the child does: nothing that is thrown may get into the code that was forked.
[[noreturn]] void run(int pipe, std::uint64_t used, const ForkedCall::Limits& limits,
                      FunctionRef<void(int)> function) noexcept {
  forget_handlers();
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, limits.seconds);
  ::alarm(30 + 4 * limits.seconds);                                  // it may wait for something without computing
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which reserve terabytes
  if (used > 0) limit(RLIMIT_AS, used + limits.bytes);
#else
  static_cast<void>(used);
#endif
  // What foreign code says on these is not for the caller's terminal.
  if (const int nowhere = ::open("/dev/null", O_RDWR); nowhere >= 0)
    for (const int stream : {standard_input, standard_output, standard_error}) ::dup2(nowhere, stream);
  function(pipe);
  ::_exit(0);
}

}  // namespace

ForkedCall::ForkedCall(const Limits& limits, FunctionRef<void(int)> function) {
  const auto fail = [] { throw std::system_error(errno, std::generic_category(), "cannot start a process"); };
  std::array<int, 2> ends{};
  if (make_pipe(ends.data()) != 0) fail();
  const std::uint64_t used = address_space();
  const pid_t process = ::fork();
  if (process == 0) run(ends[1], used, limits, function);
  const int error = errno;
  ::close(ends[1]);
  answer_ = ends[0];
  process_ = process;
  if (process > 0) return;
  process_ = 0;
  close_answer();
  errno = error;
  fail();
}

ForkedCall::~ForkedCall() {
  close_answer();
  if (process_ == 0) return;
  ::kill(static_cast<pid_t>(process_), SIGKILL);
  wait();
}

void ForkedCall::close_answer() {
  if (answer_ >= 0) ::close(answer_);
  answer_ = -1;
}

int ForkedCall::wait() {
  int status = 0;
  while (::waitpid(static_cast<pid_t>(process_), &status, 0) < 0 && errno == EINTR) continue;
  process_ = 0;
  return status;
}

std::string ForkedCall::end() {
  close_answer();  // a process that would say more ends
  const int status = wait();
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU || signal == SIGKILL || signal == SIGALRM)
    return "took too long, or too much memory, and was stopped";
  if (signal != 0) return std::string("was ended by a signal (") + ::strsignal(signal) + ")";
  return "ended without an answer";
}

}  // namespace strata::system
