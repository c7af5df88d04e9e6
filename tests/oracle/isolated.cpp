#include "oracle/isolated.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <exception>

#include "oracle/nef.h"

namespace strata::oracle {
namespace {

void write_all(int pipe, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = write(pipe, text.data() + done, text.size() - done);
    if (count <= 0) _exit(2);
    done += static_cast<std::size_t>(count);
  }
}

std::string read_all(int pipe) {
  std::string text;
  std::array<char, 4096> buffer;
  for (ssize_t count = 0; (count = read(pipe, buffer.data(), buffer.size())) > 0;) {
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return text;
}

/// The child's life: 0 and a result, or 1 and a complaint. A crash must end it, not reach the test framework's
/// handlers.
[[noreturn]] void work_in_child(int pipe, const std::function<std::string()>& work, unsigned seconds) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS}) std::signal(signal, SIG_DFL);
  alarm(seconds);
  try {
    write_all(pipe, work());
    _exit(0);
  } catch (const std::exception& e) {
    write_all(pipe, e.what());
    _exit(1);
  }
}

}  // namespace

std::string in_child(const std::function<std::string()>& work, unsigned seconds) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw OracleFailed("no pipe");
  const pid_t child = fork();
  if (child < 0) throw OracleFailed("no child process");
  if (child == 0) {
    close(ends[0]);
    work_in_child(ends[1], work, seconds);
  }
  close(ends[1]);
  std::string text = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) throw OracleFailed("crashed with signal " + std::to_string(WTERMSIG(status)));
  if (WEXITSTATUS(status) != 0) throw OracleFailed(text);
  return text;
}

}  // namespace strata::oracle
