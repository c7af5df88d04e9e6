#include "verify/child.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <iterator>
#include <system_error>
#include <thread>

#include "common/child_process.h"

namespace verify {
namespace {

using Clock = std::chrono::steady_clock;

/// What goes on between fork and exec: calls that are safe after a fork of a process with threads.
[[noreturn]] void become(char* const* arguments, const Limits& limits, const char* folder, const char* error_file) {
  setpgid(0, 0);
  tie_to_parent();
  const int nothing = open("/dev/null", O_RDWR);
  const int error = open(error_file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(nothing, STDIN_FILENO);
  dup2(nothing, STDOUT_FILENO);
  dup2(error, STDERR_FILENO);
  if (chdir(folder) != 0) _exit(127);
  constexpr rlim_t cpu_per_second = 64;  // many threads; the clock decides, this only ends what outlives the caller
  limit_for_good(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(limits.seconds)) * cpu_per_second + 1);
  if (limits.bytes != 0) limit_for_good(RLIMIT_AS, limits.bytes);
  execvp(arguments[0], arguments);
  _exit(127);
}

/// Waits for the process, and kills its group when time is over.
ChildEnd wait_for(pid_t child, double seconds) {
  ChildEnd end;
  const auto start = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  int status = 0;
  rusage usage = {};
  auto pause = std::chrono::microseconds(200);
  while (wait4(child, &status, WNOHANG, &usage) == 0) {
    if (passed() > seconds && end.how != ChildEnd::How::timed_out) {
      end.how = ChildEnd::How::timed_out;
      kill(-child, SIGKILL);
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(pause * 5 / 4, std::chrono::microseconds(10'000));
  }
  kill(-child, SIGKILL);  // whatever it has left behind
  end.seconds = passed();
  end.peak_bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  if (end.how == ChildEnd::How::timed_out) return end;
  end.how = WIFSIGNALED(status) ? ChildEnd::How::signalled : ChildEnd::How::exited;
  end.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  return end;
}

std::string end_of_file(const std::filesystem::path& path) {
  constexpr std::size_t most = 2000;
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
  return text.size() <= most ? text : "... " + text.substr(text.size() - most);
}

}  // namespace

ChildEnd run_child(const std::vector<std::string>& command, const Limits& limits, const std::filesystem::path& folder) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const std::string error_file = (folder / "stderr").string(), where = folder.string();
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "cannot start a process");
  if (child == 0) become(arguments.data(), limits, where.c_str(), error_file.c_str());
  setpgid(child, child);  // in both processes, so that the group is there whoever runs first
  ChildEnd end = wait_for(child, limits.seconds);
  end.error = end_of_file(error_file);
  return end;
}

}  // namespace verify
