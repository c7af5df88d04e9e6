// Documents of `strata batch`, and records.
#include "batch_jobs.h"
#include "batch_record.h"
#include "fuzz.h"
#include "io_error_law.h"

namespace strata::fuzz {
namespace {

constexpr const char* file_name = "folder/jobs.jsonl";

void check_line_error(const IoError& error) {
  require(error.path().starts_with(std::string(file_name) + ":"), "errors name the file and the line");
  check_error(error, error.path());
}

void check(const std::vector<BatchJob>& jobs) {
  std::size_t last = 0;
  JobEnd crash;
  crash.status = JobStatus::crashed;
  for (const BatchJob& job : jobs) {
    require(job.line > last, "jobs are in the order of their lines");
    last = job.line;
    require(!job.arguments.empty() && job.arguments[0] != "batch", "jobs have verbs");
    require(job.limits.seconds > 0 && job.limits.bytes > 0, "jobs have the limits given or their own");
    const std::string record = record_of(job, crash);
    require(record.find('\n') == record.size() - 1, "records are lines");
    const RecordKey key = read_record_key(record, file_name);
    require(key.line == job.line && key.digest == job.digest && key.status == JobStatus::crashed,
            "records can be read");
  }
}

void check(std::string_view text) {
  try {
    check(parse_batch_jobs(text, file_name, {10, 1 << 20}));
  } catch (const IoError& error) {
    check_line_error(error);
  }
  try {
    (void)read_record_key(text, std::string(file_name) + ":1");
  } catch (const IoError& error) {
    check_line_error(error);
  }
}

}  // namespace
}  // namespace strata::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return strata::fuzz::run(data, size, [](std::string_view text) { strata::fuzz::check(text); });
}
