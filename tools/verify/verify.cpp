#include "verify/verify.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "common/progress.h"
#include "common/shared_folder.h"
#include "common/text_file.h"
#include "common/usage_error.h"
#include "strata/errors.h"
#include "verify/certify.h"
#include "verify/reports.h"
#include "verify/run.h"

namespace {

namespace fs = std::filesystem;
using verify::Outcome;

fs::path folder_of_cases(const VerifySettings& settings) {
  return settings.cases.empty() ? shared_folder("data/cases") : fs::path(settings.cases);
}

bool is_wanted(const verify::Case& c, const VerifySettings& settings) {
  if (settings.tags.empty()) return true;
  return std::any_of(settings.tags.begin(), settings.tags.end(), [&](const auto& tag) { return c.has_tag(tag); });
}

std::vector<verify::Case> read_cases(const VerifySettings& settings) {
  const fs::path root = folder_of_cases(settings);
  std::vector<fs::path> folders;
  for (const std::string& slug : settings.slugs) folders.push_back(root / slug);
  if (folders.empty()) folders = verify::find_cases(root);
  std::vector<verify::Case> cases;
  for (const fs::path& folder : folders)
    if (verify::Case c = verify::read_case(folder); is_wanted(c, settings)) cases.push_back(std::move(c));
  if (cases.empty()) throw UsageError(fmt::format("no case has a tag {}", fmt::join(settings.tags, ", ")));
  return cases;
}

void check_reports(const VerifySettings& settings) {
  for (const std::string& path : settings.reports)
    if (path != "-" && !path.ends_with(".json") && !path.ends_with(".xml") && !path.ends_with(".html"))
      throw UsageError(fmt::format("cannot tell a report from {}; use .json, .xml or .html", path));
}

bool wants_pictures(const VerifySettings& settings) {
  return std::any_of(settings.reports.begin(), settings.reports.end(),
                     [](const std::string& path) { return path.ends_with(".html"); });
}

void write_reports(const verify::Run& run, const VerifySettings& settings) {
  for (const std::string& path : settings.reports) {
    if (path.ends_with(".html")) {
      write_text(path, verify::scoreboard(run, settings.workbench));
    } else if (path.ends_with(".xml")) {
      write_text(path, verify::junit_report(run));
    } else {
      write_report(path, verify::json_report(run));
    }
  }
}

std::vector<std::unique_ptr<verify::Engine>> make_engines(const VerifySettings& settings) {
  const verify::EngineFolders folders = settings.folders();
  std::vector<std::unique_ptr<verify::Engine>> engines;
  try {
    for (const std::string& name : settings.engines) engines.push_back(verify::make_engine(name, folders));
    if (engines.empty()) engines.push_back(verify::make_engine("strata", folders));
  } catch (const std::runtime_error& error) {
    throw UsageError(error.what());
  }
  return engines;
}

/// A result that is there already, judged in this process.
verify::Run judge_result(const VerifySettings& settings, std::vector<verify::Case> cases) {
  if (settings.slugs.size() != 1) throw UsageError("--result needs the one --case whose result it is");
  std::vector<std::unique_ptr<verify::Engine>> engines;
  engines.push_back(verify::make_given_result(settings.result, settings.roundoff));
  verify::RunOptions options;
  options.judge_apart = false;
  return verify::run_cases(std::move(cases), engines, options);
}

verify::Run run(const VerifySettings& settings, const verify::RunOptions& options) {
  std::vector<verify::Case> cases = read_cases(settings);
  if (settings.recertify) {
    const std::string oracle = settings.named_oracle();
    return verify::recertify(std::move(cases), oracle.empty() ? "strata-oracle" : oracle, options);
  }
  if (settings.certify && settings.engines.empty()) return verify::certify(std::move(cases), options);
  if (!settings.result.empty()) return judge_result(settings, std::move(cases));
  const auto engines = make_engines(settings);
  verify::Run result = verify::run_cases(std::move(cases), engines, options);
  if (settings.certify)
    for (std::size_t e = 0; e < engines.size(); ++e) verify::add_to_origins(result, e);
  return result;
}

/// Open defects of strata are cases with this tag: they are run, and pass as long as they are not exact.
constexpr const char* known_failure = "known-failure";

bool is_passed(const verify::Run& run, const verify::Finding& f) {
  const Outcome o = f.verdict.outcome;
  if (run.engines[f.of_engine] == "strata")
    return (o == Outcome::exact) != run.cases[f.of_case].has_tag(known_failure) && o != Outcome::oracle_failed;
  return o == Outcome::exact || o == Outcome::rounded || o == Outcome::collapsed || o == Outcome::not_applicable;
}

bool is_passed(const verify::Run& run) {
  return std::all_of(run.findings.begin(), run.findings.end(),
                     [&](const verify::Finding& f) { return is_passed(run, f); });
}

/// What begins to pass is no known failure any more.
void report_mended(const verify::Run& run) {
  for (const verify::Finding& f : run.findings)
    if (run.engines[f.of_engine] == "strata" && f.verdict.outcome == Outcome::exact &&
        run.cases[f.of_case].has_tag(known_failure))
      fmt::print("{}: exact now; remove its tag {}\n", run.cases[f.of_case].slug, known_failure);
}

}  // namespace

void add_verify_options(CLI::App& verb, VerifySettings& v, OutputSettings& output) {
  verb.add_option("--case", v.slugs, "Only this case; may be given several times")->type_name("SLUG");
  verb.add_option("--tag", v.tags, "Only cases with this tag; may be given several times")->type_name("TAG");
  add_engine_options(verb, v, "Cases", "Time for a case, by the clock");
  verb.add_option("--result", v.result, "Judge this file as the result of the one --case; no engine is asked")
      ->type_name("FILE")
      ->excludes("--engine");
  verb.add_option("--roundoff", v.roundoff, "With --result: unit roundoff of the coordinates, if not exact")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  verb.add_option("--report", v.reports, "Where reports go: .json, .xml (JUnit) or .html; - is JSON")
      ->type_name("FILE");
  verb.add_option("--workbench", v.workbench, "Where the workbench is: cases of an .html report link to it")
      ->type_name("ADDRESS");
  verb.add_option("--cases", v.cases, "Where the cases are, unless in data/cases")->type_name("FOLDER");
  verb.add_flag("--certify", v.certify,
                "Complete expected.json of new cases; with --engine, note that these engines say the same");
  verb.add_flag("--recertify", v.recertify, "Have the oracle say what is right, and note where it agrees");
  verb.add_flag("--progress", output.progress, "Show progress at once, also when not on a terminal");
  verb.add_flag("-q,--quiet", output.quiet, "No summary");
}

ExitCode run_verify(const VerifySettings& v, const OutputSettings& output) {
  check_reports(v);
  ProgressBar bar(output.progress, output.quiet);
  verify::RunOptions options;
  options.limits = v.limits();
  options.jobs = v.jobs;
  options.pictures = wants_pictures(v);
  options.progress = [&bar](double fraction) { bar.show(fraction); };
  const verify::Run result = run(v, options);
  write_reports(result, v);
  if (!output.quiet) fmt::print("{}", verify::summary(result));
  report_mended(result);
  return is_passed(result) ? ExitCode::ok : ExitCode::negative;
}
