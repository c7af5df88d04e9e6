#include "batch.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>
#include <vector>

#include "batch_pool.h"
#include "common/progress.h"
#include "common/run.h"
#include "common/tell.h"
#include "common/text_file.h"
#include "record_file.h"
#include "stop_signals.h"

namespace {

std::string summary(const RecordFile& records, std::size_t jobs) {
  std::string text = fmt::format("{} of {} jobs done: {} ok", records.done(), jobs, records.count(JobStatus::ok));
  for (const JobStatus status : {JobStatus::failed, JobStatus::timeout, JobStatus::memory, JobStatus::crashed})
    if (const std::size_t count = records.count(status)) text += fmt::format(", {} {}", count, name(status));
  return text;
}

}  // namespace

void add_batch_options(CLI::App& verb, BatchSettings& batch, Settings& settings) {
  verb.add_option("JOBS.jsonl", batch.document, "The jobs, one line each; - is standard input")->required();
  verb.add_option("-o,--output", batch.records, "Where records go, one line each; - is standard output")
      ->type_name("RECORDS.jsonl")
      ->default_str("-");
  verb.add_option("--workers", batch.workers, "Jobs at a time; as many as there are cores, if not given")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  verb.add_option("--timeout", batch.limits.seconds, "Stop a job after this time")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber);
  verb.add_option_function<std::string>(
          "--memory",
          [&batch](const std::string& word) {
            const auto bytes = byte_count(word);
            if (!bytes) throw CLI::ValidationError("--memory", "a number of bytes, as 1500000 or 1.5G, not " + word);
            batch.limits.bytes = *bytes;
          },
          "Let a job have this much memory; K, M, G and T are powers of 1024")
      ->type_name("BYTES");
  const auto resume = verb.add_flag("--resume", batch.resume, "Do not run jobs again that have a record already");
  verb.add_flag("--retry", batch.retry, "With --resume: run those again that are not ok")->needs(resume);
  verb.add_flag("--progress", settings.progress, "Show progress at once, also when not on a terminal");
  verb.add_flag("-q,--quiet", settings.quiet, "Errors only");
}

ExitCode run_batch(const BatchSettings& batch, const Settings& settings) {
  if (batch.resume && batch.records == "-") throw UsageError("--resume needs the file of the records: -o");
  if (batch.document == batch.records && batch.document != "-")
    throw UsageError("jobs and records cannot be the same file");
  StopSignals signals;
  const std::string name = batch.document == "-" ? "standard input" : batch.document;
  const std::vector<BatchJob> jobs = parse_batch_jobs(read_text(batch.document, &signals.token()), name, batch.limits);
  RecordFile records(batch.records, jobs, batch.resume, batch.retry);
  bool whole = false;
  {
    ProgressBar bar(settings.progress, settings.quiet);
    const unsigned cores = std::max(std::thread::hardware_concurrency(), 1U);
    BatchPool pool(jobs, records, batch.workers == 0 ? cores : batch.workers);
    whole = pool.run(signals, bar);
  }
  records.finish();
  if (!whole) return complain(ExitCode::stopped, "interrupted; " + summary(records, jobs.size()));
  if (!settings.quiet) tell("strata: {}\n", summary(records, jobs.size()));
  return records.count(JobStatus::ok) == jobs.size() ? ExitCode::ok : ExitCode::negative;
}
