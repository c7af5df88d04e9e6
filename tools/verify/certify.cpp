#include "verify/certify.h"

#include <fmt/format.h>

#include <mutex>
#include <stdexcept>
#include <utility>

#include "common/scratch.h"
#include "common/stopwatch.h"
#include "common/text_file.h"
#include "strata/io.h"
#include "strata/measure.h"
#include "verify/decimal.h"
#include "verify/first_error.h"
#include "verify/jobs.h"
#include "verify/strata_engine.h"

namespace verify {
namespace {

namespace fs = std::filesystem;

void write_expectation(const Case& c, const Expectation& e) {
  write_text((c.folder / "expected.json").string(), to_json(e).dump(1) + "\n");
}

/// What the author knows and the engine contradicts.
std::string contradiction(const Known& known, const Facts& facts) {
  const auto differ = [](const char* what, const auto& wanted, const auto& found) {
    return wanted && *wanted != static_cast<std::int64_t>(found)
               ? fmt::format("{} {}, known is {}", what, found, *wanted)
               : std::string();
  };
  if (known.volume && *known.volume != facts.volume)
    return fmt::format("volume {}, known is {}", decimal(facts.volume), decimal(*known.volume));
  if (known.area && abs(strata::Rational(facts.area - *known.area)) > *known.area / 10'000'000'000'000)
    return fmt::format("area {}, known is {}", decimal(facts.area), decimal(*known.area));
  for (const std::string& text :
       {differ("components", known.components, facts.components),
        differ("Euler characteristic", known.euler, facts.euler), differ("facets", known.facets, facts.form.facets),
        differ("edges", known.edges, facts.form.edges), differ("vertices", known.vertices, facts.form.vertices)})
    if (!text.empty()) return text;
  return {};
}

bool is_known(const Known& k) { return k.volume || k.area || k.components || k.euler || k.facets || k.edges; }

Verdict settle(const Case& c, const strata::ExactMesh& mesh) {
  if (const std::string why = first_error(mesh); !why.empty()) return {Outcome::invalid, why};
  const Facts facts = facts_of(mesh);
  if (const std::string why = contradiction(c.known, facts); !why.empty()) return {Outcome::wrong, why};
  Expectation found = expectation_of(facts);
  if (c.expected) {
    if (auto why = difference(found, *c.expected)) return {Outcome::wrong, *why};
    found.origin = c.expected->origin;
  }
  if (is_known(c.known)) add_origin(found, "analytic");
  add_origin(found, "strata");
  write_expectation(c, found);
  return {};
}

Verdict certify_case(const Case& c, const RunOptions& options, Finding& finding) {
  const Scratch scratch;
  const Answer answer = make_strata_engine("strata", {})->ask(c, scratch.path(), options.limits);
  finding.seconds = answer.seconds;
  if (answer.file.empty()) return answer.why_not;
  strata::MeshFile file = strata::read_mesh(answer.file);
  return settle(c, {std::move(file.mesh), std::move(file.exact)});
}

/// What the oracle wrote, compared with what is expected.
Verdict compare(const Case& c, const fs::path& file) {
  const Json json = parse_json(read_file(file.string()), file.string());
  const JsonLocation root(json, file.string());
  const auto text = [&](const char* key) { return root.at(key).text(); };
  const Json wanted = to_json(*c.expected);
  for (const char* key : {"volume", "hash"})
    if (text(key) != wanted[key].get<std::string>())
      return {Outcome::wrong, fmt::format("{} is {} for the oracle", key, text(key))};
  for (const char* key : {"vertices", "edges", "facets"})
    if (root.at(key).value() != wanted[key])
      return {Outcome::wrong, fmt::format("{} {} for the oracle", root.at(key).value().dump(), key)};
  return {};
}

Verdict recertify_case(const Case& c, const fs::path& oracle, const RunOptions& options, Finding& finding) {
  if (!c.expected) return {Outcome::oracle_failed, "the case has no expected.json: certify it first"};
  if (c.input != strata::InputClass::solid) return {Outcome::not_applicable, "operands that cross themselves"};
  const Scratch scratch;
  const fs::path out = scratch.path() / "oracle.json";
  std::vector<std::string> command = {fs::absolute(oracle).string(), c.expression, out.string()};
  for (std::string& binding : bindings_of(c, scratch.path())) command.push_back(std::move(binding));
  const ChildEnd end = run_child(command, options.limits, scratch.path());
  finding.seconds = end.seconds;
  if (end.how == ChildEnd::How::timed_out) return verdict_of(end);
  if (end.how != ChildEnd::How::exited || end.code != 0)
    return {Outcome::oracle_failed, end.error.empty() ? verdict_of(end).reason : end.error};
  Verdict verdict = compare(c, out);
  if (verdict.outcome == Outcome::exact) {
    Expectation e = *c.expected;
    if (add_origin(e, "nef")) write_expectation(c, e);
  }
  return verdict;
}

/// A run of one engine in which `work` settles a case.
template <class Work>
Run run_alone(std::vector<Case> cases, const char* engine, const RunOptions& options, const Work& work) {
  Run run;
  run.cases = std::move(cases);
  run.engines = {engine};
  run.findings.resize(run.cases.size());
  run.expected_pictures.resize(run.cases.size());
  std::mutex mutex;
  std::size_t done = 0;
  Stopwatch stopwatch;
  for_each_in_jobs(run.cases.size(), options.jobs, [&](std::size_t k) {
    Finding& finding = run.findings[k];
    finding.of_case = k;
    finding.verdict = work(run.cases[k], finding);
    const std::scoped_lock lock(mutex);
    if (options.progress) options.progress(static_cast<double>(++done) / static_cast<double>(run.cases.size()));
  });
  run.seconds = stopwatch.lap();
  return run;
}

}  // namespace

Run certify(std::vector<Case> cases, const RunOptions& options) {
  return run_alone(std::move(cases), "certify", options,
                   [&](const Case& c, Finding& finding) { return certify_case(c, options, finding); });
}

void add_to_origins(const Run& run, std::size_t engine) {
  for (const Finding& f : run.findings) {
    if (f.of_engine != engine || f.verdict.outcome != Outcome::exact) continue;
    const Case& c = run.cases[f.of_case];
    Expectation e = read_expectation(c.folder / "expected.json");
    if (add_origin(e, run.engines[engine])) write_expectation(c, e);
  }
}

Run recertify(std::vector<Case> cases, const fs::path& oracle, const RunOptions& options) {
  return run_alone(std::move(cases), "nef", options,
                   [&](const Case& c, Finding& finding) { return recertify_case(c, oracle, options, finding); });
}

}  // namespace verify
