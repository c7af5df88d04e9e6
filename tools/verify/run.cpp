#include "verify/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "common/scratch.h"
#include "common/stopwatch.h"
#include "strata/io.h"
#include "verify/jobs.h"
#include "verify/judge.h"
#include "verify/judge_apart.h"
#include "verify/sketch.h"

namespace verify {

namespace {

/// A picture of a mesh in a file; none of one that cannot be read.
std::string picture_of(const std::filesystem::path& file) {
  try {
    return sketch(strata::read_mesh(file).mesh);
  } catch (const strata::IoError&) {
    return {};
  }
}

bool is_right(const Finding& f) {
  const Outcome o = f.verdict.outcome;
  return o == Outcome::exact || o == Outcome::rounded || o == Outcome::collapsed;
}

/// Pictures are made of results that are not right, and of those of this engine that are.
Finding run_case(const Case& c, const Engine& engine, const RunOptions& options) {
  Finding finding;
  if (!c.expected) {
    finding.verdict = {Outcome::oracle_failed, "the case has no expected.json"};
    return finding;
  }
  const Scratch scratch;
  const Answer answer = engine.ask(c, scratch.path(), options.limits);
  finding.seconds = answer.seconds;
  finding.peak_bytes = answer.peak_bytes;
  if (answer.file.empty()) {
    finding.verdict = answer.why_not;
    return finding;
  }
  finding.verdict = options.judge_apart
                        ? judge_apart(answer.file, c, engine.unit_roundoff(), options.limits, scratch.path())
                        : judge_file(answer.file, c, yardstick_for(c, engine.unit_roundoff()));
  if (finding.verdict.outcome == Outcome::wrong && !answer.collapsed.empty())
    finding.verdict = {Outcome::collapsed, fmt::format("{} ({})", finding.verdict.reason, answer.collapsed)};
  if (options.pictures && (!is_right(finding) || engine.name() == "strata")) finding.picture = picture_of(answer.file);
  return finding;
}

}  // namespace

Run run_cases(std::vector<Case> cases, const std::vector<std::unique_ptr<Engine>>& engines, const RunOptions& options) {
  Run run;
  run.cases = std::move(cases);
  for (const auto& engine : engines) run.engines.push_back(engine->name());
  run.findings.resize(run.cases.size() * engines.size());
  run.expected_pictures.resize(run.cases.size());
  std::mutex mutex;
  std::size_t done = 0;
  Stopwatch stopwatch;
  for_each_in_jobs(run.findings.size(), options.jobs, [&](std::size_t k) {
    const std::size_t of_case = k / engines.size(), of_engine = k % engines.size();
    Finding finding = run_case(run.cases[of_case], *engines[of_engine], options);
    finding.of_case = of_case;
    finding.of_engine = of_engine;
    if (is_right(finding)) std::swap(run.expected_pictures[of_case], finding.picture);
    run.findings[k] = std::move(finding);
    const std::scoped_lock lock(mutex);
    if (options.progress) options.progress(static_cast<double>(++done) / static_cast<double>(run.findings.size()));
  });
  run.seconds = stopwatch.lap();
  return run;
}

std::size_t count(const Run& run, std::size_t engine, Outcome outcome) {
  return static_cast<std::size_t>(std::count_if(run.findings.begin(), run.findings.end(), [&](const Finding& f) {
    return f.of_engine == engine && f.verdict.outcome == outcome;
  }));
}

}  // namespace verify
