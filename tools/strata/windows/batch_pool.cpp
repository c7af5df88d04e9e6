#include "batch_pool.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>

#include "captured_text.h"
#include "common/exit_code.h"
#include "common/scratch.h"
#include "common/sibling_program.h"
#include "common/text_file.h"
#include "core/system/program.h"

namespace {

strata::system::Command command_of(const BatchJob& job, const std::filesystem::path& folder) {
  strata::system::Command command;
  command.words = {own_program().string()};
  command.words.insert(command.words.end(), job.arguments.begin(), job.arguments.end());
  command.output = folder / "output";
  command.error = folder / "error";
  command.bytes = job.limits.bytes;
  return command;
}

std::string captured(const std::filesystem::path& path) {
  const std::string text = read_file(path.string());
  return captured_text(text.size(), [&](std::size_t offset, std::size_t size) { return text.substr(offset, size); });
}

JobStatus status_of(const JobEnd& end, bool expired) {
  if (expired) return JobStatus::timeout;
  if (end.signal) return JobStatus::crashed;
  if (*end.exit_code == static_cast<int>(ExitCode::ok)) return JobStatus::ok;
  return *end.exit_code == static_cast<int>(ExitCode::stopped) ? JobStatus::memory : JobStatus::failed;
}

}  // namespace

struct BatchPool::Running {
  Running(const BatchJob& its_job, std::size_t its_number)
      : job(its_job), number(its_number), process(command_of(its_job, folder.path())) {}

  /// How it ended; nothing while it runs.
  std::optional<JobEnd> end() {
    JobEnd result;
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const bool is_late = job.limits.seconds > 0 && result.seconds > job.limits.seconds;
    auto ended = process.end();
    const bool expired = is_late && !ended;
    if (expired) process.kill();
    if (expired) ended = process.wait();
    if (!ended) return std::nullopt;
    result.peak_bytes = ended->peak_bytes;
    if (ended->crashed) {
      result.signal = ended->code;
    } else if (!expired) {
      result.exit_code = ended->code;
    }
    result.status = status_of(result, expired);
    result.error = captured(folder.path() / "error");
    result.output = captured(folder.path() / "output");
    return result;
  }

  const BatchJob& job;
  std::size_t number;
  Scratch folder;
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
  strata::system::Process process;
};

BatchPool::BatchPool(const std::vector<BatchJob>& jobs, RecordFile& records, unsigned workers)
    : jobs_(jobs), records_(records), workers_(std::max(workers, 1U)) {}

BatchPool::~BatchPool() = default;

bool BatchPool::run(StopSignals& signals, ProgressBar& bar) {
  while (records_.done() < jobs_.size()) {
    if (signals.token().is_cancelled()) {
      running_.clear();
      return false;
    }
    start_some();
    if (!take_ends()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      continue;
    }
    records_.write();
    bar.show(static_cast<double>(records_.done()) / static_cast<double>(jobs_.size()));
  }
  return true;
}

void BatchPool::start_some() {
  for (; next_ < jobs_.size() && running_.size() < workers_; ++next_)
    if (!records_.has(next_)) running_.push_back(std::make_unique<Running>(jobs_[next_], next_));
}

bool BatchPool::take_ends() {
  const std::size_t before = running_.size();
  std::erase_if(running_, [&](const std::unique_ptr<Running>& one) {
    const std::optional<JobEnd> end = one->end();
    if (end) records_.add(one->number, end->status, record_of(one->job, *end));
    return end.has_value();
  });
  return running_.size() < before;
}
