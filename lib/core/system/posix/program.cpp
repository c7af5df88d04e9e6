#include "core/system/program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/prctl.h>
#elif defined(__APPLE__)
#include <mach-o/dyld.h>
#endif

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <system_error>

#include "core/system/file.h"
#include "core/system/posix/after_fork.h"

namespace strata::system {

namespace fs = std::filesystem;

const char path_separator = ':';
const char* const program_suffix = "";

fs::path own_program() {
#if defined(__APPLE__)
  std::string name(4096, '\0');
  std::uint32_t size = static_cast<std::uint32_t>(name.size());
  return ::_NSGetExecutablePath(name.data(), &size) == 0 ? fs::canonical(name.c_str()) : fs::path();
#else
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored);
#endif
}

std::uint64_t process_number() { return static_cast<std::uint64_t>(::getpid()); }

bool is_program(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
}

void limit_for_good(int resource, std::uint64_t value) {
  const rlimit both{value, value};
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

void tie_to_parent() {
#if defined(__linux__)
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  limit_for_good(RLIMIT_CORE, 0);
}

namespace {

/// What goes on between fork and exec, in plain memory: only calls that are safe after a fork of a process with
/// threads.
struct Preparation {
  char* const* arguments;
  const char* folder;  ///< null: here
  const char* output;  ///< null: nowhere
  const char* error;
  double seconds;
  std::uint64_t bytes;
};

int open_for_child(const char* file, int otherwise) {
  return file == nullptr ? otherwise : ::open(file, O_WRONLY | O_CREAT | O_APPEND, 0600);
}

[[noreturn]] void become_child(const Preparation& child) {
  ::setpgid(0, 0);
  tie_to_parent();
  const int nothing = ::open("/dev/null", O_RDWR);
  const int output = open_for_child(child.output, nothing), error = open_for_child(child.error, nothing);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(error, STDERR_FILENO);
  if (child.folder != nullptr && ::chdir(child.folder) != 0) ::_exit(127);
  if (child.seconds > 0) limit_for_good(RLIMIT_CPU, static_cast<std::uint64_t>(std::ceil(child.seconds)));
  if (child.bytes > 0) limit_for_good(RLIMIT_AS, child.bytes);
  ::execvp(child.arguments[0], child.arguments);
  ::_exit(127);
}

const char* name_or_null(const fs::path& path) { return path.empty() ? nullptr : path.c_str(); }

}  // namespace

struct Process::Handle {
  pid_t number = -1;
  std::optional<ProcessEnd> end;

  /// Takes the end of the process; false where it still runs and nobody waits.
  bool take(int options) {
    if (end) return true;
    int status = 0;
    rusage usage = {};
    pid_t ended = 0;
    do {
      ended = ::wait4(number, &status, options, &usage);
    } while (ended < 0 && errno == EINTR);
    if (ended == 0) return false;
    ::kill(-number, SIGKILL);  // whatever it has left behind
    end.emplace();
    end->crashed = WIFSIGNALED(status);
    end->code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    end->peak_bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
    return true;
  }
};

Process::Process(const Command& command) : handle_(std::make_unique<Handle>()) {
  for (const fs::path& file : {command.output, command.error})
    if (const int empty = file.empty() ? -1 : open_to_write(file, false); empty >= 0) ::close(empty);
  std::vector<char*> arguments;
  for (const std::string& word : command.words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const Preparation child{arguments.data(),
                          name_or_null(command.folder),
                          name_or_null(command.output),
                          name_or_null(command.error),
                          command.seconds,
                          command.bytes};
  handle_->number = ::fork();
  if (handle_->number < 0) throw std::system_error(errno, std::generic_category(), "cannot start a process");
  if (handle_->number == 0) become_child(child);
  ::setpgid(handle_->number, handle_->number);  // in both processes, so that the group is there whoever runs first
}

Process::~Process() {
  if (handle_->end) return;
  kill();
  (void)wait();
}

std::optional<ProcessEnd> Process::end() {
  (void)handle_->take(WNOHANG);
  return handle_->end;
}

ProcessEnd Process::wait() {
  (void)handle_->take(0);
  return *handle_->end;
}

void Process::kill() {
  if (!handle_->end) ::kill(-handle_->number, SIGKILL);
}

std::string name_of_crash(int code) {
  return std::string("signal ") + std::to_string(code) + " (" + ::strsignal(code) + ")";
}

void become(const fs::path& program, char* const* arguments) { ::execv(program.c_str(), arguments); }

}  // namespace strata::system
