#pragma once
#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "batch_claims.h"
#include "batch_jobs.h"
#include "batch_record.h"
#include "captured_stream.h"

/// Before the text of a record in the pipe from a worker to its parent.
struct RecordHeader {
  std::uint64_t job = 0;
  std::uint64_t status = 0;  ///< a JobStatus
  std::uint64_t size = 0;    ///< of the record, in bytes
};

/// What a worker needs, made by the parent before it forks.
struct WorkerTask {
  const std::vector<BatchJob>& jobs;
  BatchClaims& claims;
  std::size_t number = 0;  ///< of the worker
  const CapturedStream& output;
  const CapturedStream& error;
  int records = -1;  ///< the writing end of a pipe
  pid_t parent = 0;
};

/// Executes jobs in this process, which has just been forked from one without other threads, until there are no more,
/// or until one of them may have left something wrong in it: memory that ran out, an error of the program.
[[noreturn]] void run_worker(const WorkerTask& task);

/// Does standard error say that a process ended because memory ran out, where nothing else does?
[[nodiscard]] bool tells_of_memory(const std::string& error);
