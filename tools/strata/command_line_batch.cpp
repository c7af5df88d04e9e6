#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "batch.h"
#include "command_line.h"

void add_batch_verb(CommandLine& line) {
  Settings& settings = line.settings;
  const auto batch = std::make_shared<BatchSettings>();
  CLI::App* verb = line.app.add_subcommand("batch", "Many independent jobs, by a pool of processes");
  add_batch_options(*verb, *batch, settings);
  verb->footer(fmt::format(
      R"text(JOBS.jsonl has a job in each line; "id", "timeout" and "memory" may be left out:
  {{"id": "a", "args": ["union", "a.stl", "b.stl", "-o", "c.stl"], "timeout": 10, "memory": "2G"}}
A job runs on one thread, unless it says -j. A record has its status: ok, failed, timeout, memory or crashed.

Examples:
  strata batch jobs.jsonl -o records.jsonl --timeout 60 --memory 2G
  strata batch jobs.jsonl -o records.jsonl --resume
  make-jobs | strata batch - --workers 8 | grep -v '"status":"ok"'

{})text",
      exit_codes));
  line.on(*verb, [&settings, batch] { return run_batch(*batch, settings); });
}
