#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "batch_jobs.h"
#include "batch_record.h"
#include "common/progress.h"
#include "record_file.h"
#include "stop_signals.h"

/// The processes that execute a batch: one for each job, which Windows starts in some 10 ms, with as many threads as
/// its -j says, or as there are cores. A job that crashes, or takes too long, has a record that says so.
class BatchPool {
 public:
  /// Executes the jobs that `records` does not have.
  BatchPool(const std::vector<BatchJob>& jobs, RecordFile& records, unsigned workers);
  ~BatchPool();  ///< kills what runs
  BatchPool(const BatchPool&) = delete;
  BatchPool& operator=(const BatchPool&) = delete;

  /// Until every job has a record, or the user stops it: false then, and the processes are stopped. Throws
  /// strata::IoError when a record cannot be written, std::system_error when there is no process to be had.
  [[nodiscard]] bool run(StopSignals& signals, ProgressBar& bar);

 private:
  struct Running;

  void start_some();
  /// Takes the ends of processes; true when there were some.
  bool take_ends();

  const std::vector<BatchJob>& jobs_;
  RecordFile& records_;
  std::size_t workers_;
  std::size_t next_ = 0;  ///< all jobs before it were started, or have a record
  std::vector<std::unique_ptr<Running>> running_;
};
