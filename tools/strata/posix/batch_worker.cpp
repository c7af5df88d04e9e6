#include "batch_worker.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "common/run.h"
#include "common/stopwatch.h"
#include "core/system/posix/after_fork.h"
#include "run_command.h"
#include "suite.h"
#include "worker_memory.h"

namespace {

/// Of this process; for the handler of failed allocations.
WorkerState* own_state = nullptr;

[[noreturn]] void note_out_of_memory() {
  own_state->out_of_memory = true;
  throw std::bad_alloc();
}

void enter(const WorkerTask& task) {
  setpgid(0, 0);  // Ctrl-C is for the parent
  strata::system::tie_to_parent();
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(nothing, STDIN_FILENO);
  task.output.replace(STDOUT_FILENO);
  task.error.replace(STDERR_FILENO);
  own_state = &task.claims.state(task.number);
  std::set_new_handler(note_out_of_memory);
  // The stack and the heap of the thread that watches every job stay: no job has to pay for them.
  std::thread([] { const auto some = std::make_unique<char[]>(4096); }).join();
}

/// A verb of another program, as a child of this process: it ends with it.
int run_suite(char** arguments) {
  const pid_t child = fork();
  if (child == 0) {
    strata::system::tie_to_parent();
    _exit(become_suite(arguments));
  }
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return child > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : static_cast<int>(ExitCode::internal);
}

int run_arguments(const BatchJob& job) {
  std::string program = "strata";
  std::vector<std::string> words = job.arguments;
  std::vector<char*> arguments = {program.data()};
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  if (is_suite_verb(words[0])) return run_suite(arguments.data());
  const Action command = [&] {
    return static_cast<ExitCode>(run_command(static_cast<int>(words.size()) + 1, arguments.data(), 1));
  };
  return static_cast<int>(run(command, {}));
}

JobStatus status_of(int exit_code) {
  if (exit_code == 0) return JobStatus::ok;
  return own_state->out_of_memory ? JobStatus::memory : JobStatus::failed;
}

std::int64_t now() { return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count(); }

JobEnd execute(const BatchJob& job, std::size_t number, WorkerMemory& memory) {
  own_state->out_of_memory = false;
  own_state->started = now();
  own_state->job = number;
  JobEnd end;
  Stopwatch stopwatch;
  memory.begin(job.limits.bytes);
  end.exit_code = run_arguments(job);
  memory.end();
  end.seconds = stopwatch.lap();
  end.peak_bytes = memory.peak();
  end.status = status_of(*end.exit_code);
  std::cout.flush();
  std::cout.clear();
  std::cin.clear();
  std::fflush(nullptr);
  return end;
}

void send(int pipe, std::string_view bytes) {
  while (!bytes.empty()) {
    const ::ssize_t done = write(pipe, bytes.data(), bytes.size());
    if (done < 0 && errno != EINTR) _exit(static_cast<int>(ExitCode::file));  // nobody listens any more
    if (done > 0) bytes.remove_prefix(static_cast<std::size_t>(done));
  }
}

void report(const WorkerTask& task, std::size_t job, JobEnd end) {
  end.error = task.error.take();
  end.output = task.output.take();
  const std::string record = record_of(task.jobs[job], end);
  const RecordHeader header{job, static_cast<std::uint64_t>(end.status), record.size()};
  std::string message(reinterpret_cast<const char*>(&header), sizeof header);
  send(task.records, message += record);
}

}  // namespace

void run_worker(const WorkerTask& task) {
  enter(task);
  WorkerMemory memory;
  while (getppid() == task.parent) {
    const std::optional<std::size_t> job = task.claims.claim(task.number);
    if (!job) break;
    const JobEnd end = execute(task.jobs[*job], *job, memory);
    own_state->job = WorkerState::none;
    report(task, *job, end);
    if (end.status == JobStatus::memory || end.exit_code == static_cast<int>(ExitCode::internal)) break;
  }
  _exit(0);
}

bool tells_of_memory(const std::string& error) {
  return error.find("std::bad_alloc") != error.npos || error.find("GNU MP: Cannot allocate memory") != error.npos;
}
