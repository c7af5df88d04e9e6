#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/json_report.h"

/// What a job may take; 0: no limit.
struct JobLimits {
  double seconds = 0;       ///< by the clock
  std::uint64_t bytes = 0;  ///< of address space, beside what the worker has when the job starts
};

/// A line of a batch: a command line and its limits.
struct BatchJob {
  std::size_t line = 0;  ///< in the document, from 1
  std::string digest;    ///< SHA-256 of the line
  Json id;               ///< a string, a number or null, as the line has it
  std::vector<std::string> arguments;
  JobLimits limits;

  /// The file that the arguments name with -o; empty: none.
  [[nodiscard]] std::string output() const;
};

/// Reads the lines of a document, of which `name` is the path; empty lines are left out. A job has these limits where
/// it names none. Throws strata::IoError with the number of the first line that is no job.
[[nodiscard]] std::vector<BatchJob> parse_batch_jobs(std::string_view text, const std::string& name,
                                                     const JobLimits& limits);

/// "1500000", "1.5G": bytes; K, M, G and T are powers of 1024. None for what is no positive number.
[[nodiscard]] std::optional<std::uint64_t> byte_count(std::string_view text);
