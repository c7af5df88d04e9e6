#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "batch_jobs.h"

/// How a job ended.
enum class JobStatus { ok, failed, timeout, memory, crashed };

[[nodiscard]] const char* name(JobStatus status);

/// What a record tells beside the job itself.
struct JobEnd {
  JobStatus status = JobStatus::ok;
  std::optional<int> exit_code;  ///< none where there was no exit
  std::optional<int> signal;     ///< that ended it
  double seconds = 0;
  std::uint64_t peak_bytes = 0;
  std::string error;   ///< what it wrote on standard error
  std::string output;  ///< the same on standard output
};

/// A record is a line of JSON, with its line end.
[[nodiscard]] std::string record_of(const BatchJob& job, const JobEnd& end);

/// What is needed to know whether a record is that of a job, and to count it.
struct RecordKey {
  std::size_t line = 0;
  std::string digest;
  JobStatus status = JobStatus::ok;
};

/// Throws strata::IoError, with the place `where`, for what is no record.
[[nodiscard]] RecordKey read_record_key(std::string_view record, const std::string& where);
