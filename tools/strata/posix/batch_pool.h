#pragma once
#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "batch_claims.h"
#include "batch_jobs.h"
#include "batch_record.h"
#include "captured_stream.h"
#include "common/progress.h"
#include "record_file.h"
#include "stop_signals.h"

/// The processes that execute a batch, as their parent sees them. A worker that crashes, or whose job takes too long,
/// is replaced; its job has a record that says so. The parent has no other threads, and computes nothing.
class BatchPool {
 public:
  /// Executes the jobs that `records` does not have. Throws std::system_error.
  BatchPool(const std::vector<BatchJob>& jobs, RecordFile& records, unsigned workers);
  ~BatchPool();  ///< kills the workers
  BatchPool(const BatchPool&) = delete;
  BatchPool& operator=(const BatchPool&) = delete;

  /// Until every job has a record, or a signal comes: false then, and the workers are stopped. Throws strata::IoError
  /// when a record cannot be written.
  [[nodiscard]] bool run(StopSignals& signals, ProgressBar& bar);

 private:
  struct Worker {
    std::size_t number = 0;
    pid_t process = -1;  ///< none: it has ended
    int records = -1;    ///< the reading end of its pipe
    std::string begun;   ///< of what came from there, the part that is not a whole record yet
    CapturedStream output, error;
  };

  void start(Worker& worker);
  [[nodiscard]] bool wait(const StopSignals& signals);
  [[nodiscard]] int milliseconds_to_wait();
  /// Takes what is in the pipe. False at its end: the process has ended.
  [[nodiscard]] bool receive(Worker& worker);
  void take_records(Worker& worker);
  /// Until the time of a job is over that the worker executed a moment ago. It may have gone on: never too few.
  [[nodiscard]] double seconds_left(const Worker& worker, std::uint64_t job);
  /// The process has ended. `expired`: the job for which it was killed, or none.
  void bury(Worker& worker, std::uint64_t expired);
  void record_death(Worker& worker, std::size_t job, JobEnd end);
  void kill_all();

  const std::vector<BatchJob>& jobs_;
  RecordFile& records_;
  BatchClaims claims_;
  std::vector<std::unique_ptr<Worker>> workers_;
  bool limited_;  ///< does any job have a time limit?
};
