#include "verify/run.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "scratch.h"
#include "stopwatch.h"
#include "verify/jobs.h"
#include "verify/judge.h"
#include "verify/sketch.h"

namespace verify {

Finding run_case(const Case& c, const Engine& engine, const Limits& limits, strata::ExactMesh& mesh) {
  Finding finding;
  if (!c.expected) {
    finding.verdict = {Outcome::oracle_failed, "the case has no expected.json"};
    return finding;
  }
  const Scratch scratch;
  const Answer answer = engine.ask(c, scratch.path(), limits);
  finding.seconds = answer.seconds;
  finding.peak_bytes = answer.peak_bytes;
  finding.verdict =
      answer.file.empty() ? answer.why_not : judge_file(answer.file, c, yardstick_for(c, engine.unit_roundoff()), mesh);
  return finding;
}

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
    strata::ExactMesh mesh;
    Finding finding = run_case(run.cases[of_case], *engines[of_engine], options.limits, mesh);
    finding.of_case = of_case;
    finding.of_engine = of_engine;
    const bool is_right = finding.verdict.outcome == Outcome::exact || finding.verdict.outcome == Outcome::rounded;
    if (options.pictures && !is_right && !mesh.mesh.triangles.empty()) finding.picture = sketch(mesh.mesh);
    if (options.pictures && is_right && run.engines[of_engine] == "strata")
      run.expected_pictures[of_case] = sketch(mesh.mesh);
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
