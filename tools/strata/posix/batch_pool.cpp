#include "batch_pool.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <utility>

#include "batch_worker.h"

namespace {

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

double seconds_since(std::int64_t start) {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now - std::chrono::nanoseconds(start)).count();
}

std::size_t pool_size(std::size_t jobs, unsigned workers) {
  return std::min<std::size_t>(workers, std::max<std::size_t>(jobs, 1));
}

/// How a process ended that did not live to write the record itself.
JobEnd end_of_process(int status, const rusage& usage, bool expired) {
  JobEnd end;
  end.peak_bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  end.status = expired ? JobStatus::timeout : WIFSIGNALED(status) ? JobStatus::crashed : JobStatus::failed;
  if (WIFSIGNALED(status))
    end.signal = WTERMSIG(status);
  else
    end.exit_code = WEXITSTATUS(status);
  return end;
}

}  // namespace

BatchPool::BatchPool(const std::vector<BatchJob>& jobs, RecordFile& records, unsigned workers)
    : jobs_(jobs), records_(records), claims_(jobs.size(), pool_size(jobs.size() - records.done(), workers)) {
  limited_ = std::any_of(jobs.begin(), jobs.end(), [](const BatchJob& job) { return job.limits.seconds > 0; });
  for (std::size_t k = 0; k < jobs.size(); ++k)
    if (records.has(k)) claims_.withhold(k);
  for (std::size_t k = 0; k < pool_size(jobs.size() - records.done(), workers); ++k) {
    workers_.push_back(std::make_unique<Worker>());
    workers_.back()->number = k;
  }
}

BatchPool::~BatchPool() { kill_all(); }

bool BatchPool::run(StopSignals& signals, ProgressBar& bar) {
  signals.hold();
  if (records_.done() == jobs_.size()) return true;
  for (const auto& worker : workers_) start(*worker);
  while (records_.done() < jobs_.size()) {
    if (!wait(signals)) {
      kill_all();
      return false;
    }
    for (const auto& worker : workers_) {
      if (worker->process < 0) continue;
      const std::uint64_t job = claims_.state(worker->number).job;
      const bool expired = seconds_left(*worker, job) <= 0;
      if (expired) kill(-worker->process, SIGKILL);
      if (expired || !receive(*worker)) bury(*worker, expired ? job : WorkerState::none);
    }
    records_.write();
    bar.show(static_cast<double>(records_.done()) / static_cast<double>(jobs_.size()));
  }
  return true;
}

void BatchPool::start(Worker& worker) {
  std::array<int, 2> ends = {};
  if (pipe(ends.data()) != 0) fail("pipe");
  for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  claims_.state(worker.number).job = WorkerState::none;  // a former process may have left one
  std::fflush(nullptr);
  const pid_t parent = getpid();
  worker.process = fork();
  if (worker.process == 0) run_worker({jobs_, claims_, worker.number, worker.output, worker.error, ends[1], parent});
  close(ends[1]);
  worker.records = ends[0];
  worker.begun.clear();
  if (worker.process < 0) fail("cannot start a process");
  setpgid(worker.process, worker.process);  // in both processes, so that the group is there whoever runs first
}

/// Until something happens. False when it was a signal.
bool BatchPool::wait(const StopSignals& signals) {
  if (signals.token().is_cancelled()) return false;
  std::vector<pollfd> pipes;
  for (const auto& worker : workers_)
    if (worker->process >= 0) pipes.push_back({worker->records, POLLIN, 0});
  const int milliseconds = milliseconds_to_wait();
  const timespec time = {milliseconds / 1000, milliseconds % 1000 * 1'000'000L};
  const int ready = ppoll(pipes.data(), pipes.size(), milliseconds < 0 ? nullptr : &time, &signals.mask());
  if (ready < 0 && errno != EINTR) fail("poll");
  return !signals.token().is_cancelled();
}

/// A job may begin while the parent sleeps, so it never sleeps long where a job has a limit.
int BatchPool::milliseconds_to_wait() {
  constexpr double longest = 50;
  if (!limited_) return -1;
  double left = longest;
  for (const auto& worker : workers_)
    if (worker->process >= 0)
      left = std::min(left, std::ceil(1000 * seconds_left(*worker, claims_.state(worker->number).job)));
  return static_cast<int>(std::max(left, 0.0));
}

bool BatchPool::receive(Worker& worker) {
  std::array<char, 1 << 16> block;
  while (true) {
    const ::ssize_t got = read(worker.records, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return got < 0;
    worker.begun.append(block.data(), static_cast<std::size_t>(got));
    take_records(worker);
  }
}

void BatchPool::take_records(Worker& worker) {
  std::size_t done = 0;
  while (true) {
    RecordHeader header;
    const std::size_t left = worker.begun.size() - done;
    if (left < sizeof header) break;
    std::memcpy(&header, worker.begun.data() + done, sizeof header);
    if (left - sizeof header < header.size) break;
    done += sizeof header;
    records_.add(header.job, static_cast<JobStatus>(header.status), worker.begun.substr(done, header.size));
    done += header.size;
  }
  worker.begun.erase(0, done);
}

double BatchPool::seconds_left(const Worker& worker, std::uint64_t job) {
  constexpr double forever = 1e9;
  if (job == WorkerState::none || jobs_[job].limits.seconds == 0) return forever;
  return jobs_[job].limits.seconds - seconds_since(claims_.state(worker.number).started);
}

/// At most one job of a worker has no record: the one that it executed. If this is not the one that took too long, the
/// latter ended just in time, and the former is executed again.
void BatchPool::bury(Worker& worker, std::uint64_t expired) {
  int status = 0;
  rusage usage = {};
  while (wait4(worker.process, &status, 0, &usage) < 0 && errno == EINTR) continue;
  kill(-worker.process, SIGKILL);  // whatever it has left behind
  worker.process = -1;
  (void)receive(worker);  // all that it has sent
  close(worker.records);
  for (std::size_t k = 0; k < jobs_.size(); ++k) {
    if (!claims_.belongs_to(k, worker.number) || records_.has(k)) continue;
    if (expired != WorkerState::none && expired != k)
      claims_.give_back(k);
    else
      record_death(worker, k, end_of_process(status, usage, expired == k));
  }
  worker.error.clear();
  worker.output.clear();
  if (claims_.any_left()) start(worker);
}

void BatchPool::record_death(Worker& worker, std::size_t job, JobEnd end) {
  const WorkerState& state = claims_.state(worker.number);
  if (state.job == job) end.seconds = seconds_since(state.started);
  end.error = worker.error.take();
  end.output = worker.output.take();
  if (end.status != JobStatus::timeout && (state.out_of_memory || tells_of_memory(end.error)))
    end.status = JobStatus::memory;
  records_.add(job, end.status, record_of(jobs_[job], end));
}

void BatchPool::kill_all() {
  for (const auto& worker : workers_) {
    if (worker->process < 0) continue;
    kill(-worker->process, SIGKILL);
    while (waitpid(worker->process, nullptr, 0) < 0 && errno == EINTR) continue;
    worker->process = -1;
    (void)receive(*worker);
    close(worker->records);
  }
}
