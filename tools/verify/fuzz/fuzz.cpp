#include "verify/fuzz/fuzz.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "common/sibling_program.h"
#include "common/stopwatch.h"
#include "common/tell.h"
#include "common/usage_error.h"
#include "common/watch.h"
#include "verify/fuzz/findings.h"
#include "verify/fuzz/laws.h"
#include "verify/jobs.h"

namespace {

namespace fs = std::filesystem;

/// The oracle asked for, or the one in the path; empty if there is none.
fs::path oracle_of(const FuzzSettings& f) {
  const std::string asked = f.named_oracle();
  if (!asked.empty()) {
    if (!fs::exists(asked)) throw UsageError(fmt::format("there is no oracle {}", asked));
    return fs::absolute(asked);
  }
  return program_in_path("strata-oracle");
}

std::vector<std::string> engines_of(const FuzzSettings& f) {
  return f.engines.empty() ? std::vector<std::string>{"strata"} : f.engines;
}

std::unique_ptr<fuzz::Evaluator> evaluator_of(const FuzzSettings& f, const std::string& engine) {
  if (engine == "strata") return fuzz::library_evaluator();
  try {
    return fuzz::engine_evaluator(engine, f.folders(), f.limits());
  } catch (const std::runtime_error& error) {
    throw UsageError(error.what());
  }
}

/// The checks of one case, in this process: what every round does in a process of its own.
ExitCode replay(const FuzzSettings& f) {
  const verify::Case c = verify::read_case(f.replay);
  const fuzz::Oracle oracle = {oracle_of(f), {f.seconds, 0}};
  for (const std::string& engine : engines_of(f)) {
    try {
      fuzz::ensure_laws(c, *evaluator_of(f, engine), oracle, f.check);
    } catch (const fuzz::Broken& broken) {
      constexpr std::size_t most = 1500;
      tell("{}: {}\n", broken.check(), std::string(broken.what()).substr(0, most));
      return ExitCode::negative;
    } catch (const fuzz::NoQuestion& why) {
      tell("strata: {}\n", why.what());
      return ExitCode::invalid_input;
    }
  }
  return ExitCode::ok;
}

/// A command whose words are files here is found from other folders, too.
std::string found_from_anywhere(const std::string& engine) {
  const std::size_t equals = engine.find('=');
  const std::size_t start = equals == std::string::npos || engine.find_first_of(" /") < equals ? 0 : equals + 1;
  std::string result = engine.substr(0, start);
  for (std::size_t at = start; at < engine.size();) {
    const std::size_t end = std::min(engine.find(' ', at), engine.size());
    const std::string word = engine.substr(at, end - at);
    result += word.find('/') != std::string::npos && fs::exists(word) ? fs::absolute(word).string() : word;
    if (end < engine.size()) result += ' ';
    at = end + 1;
  }
  return result;
}

/// Rounds of a seed, several at a time.
class Search {
 public:
  Search(const FuzzSettings& f, const OutputSettings& output) : f_(f), output_(output), oracle_(oracle_of(f)) {
    for (const std::string& engine : engines_of(f)) {
      engines_.push_back(found_from_anywhere(engine));
      (void)evaluator_of(f, engine);  // says at once if there is no such engine
    }
    asking_.program = own_program().string();
    asking_.limits = f.limits();
    asking_.words = {
        "--seconds", fmt::format("{}", f.seconds), "--memory",  std::to_string(f.megabytes),
        "--python",  f.folders().python,           "--scripts", fs::absolute(f.folders().scripts).string()};
    if (!oracle_.empty()) asking_.words.insert(asking_.words.end(), {"--oracle", oracle_.string()});
  }

  [[nodiscard]] ExitCode run() {
    watch_.hold();  // rounds that have begun end, and what was found is said
    if (f_.only) {
      run_batch(*f_.only, 1);
    } else if (f_.minutes > 0) {
      constexpr std::uint64_t batch = 64;
      for (std::uint64_t first = 0; has_time(); first += batch) run_batch(first, batch);
    } else {
      run_batch(0, f_.rounds);
    }
    if (!output_.quiet)
      fmt::print("seed {}: {} rounds asked, {} passed over, {} findings, {:.1f} s{}\n", f_.seed, asked_.load(),
                 passed_over_.load(), findings_, stopwatch_.lap(),
                 watch_.token().is_cancelled() ? ", interrupted" : "");
    if (findings_ != 0) return ExitCode::negative;
    return watch_.token().is_cancelled() ? ExitCode::stopped : ExitCode::ok;
  }

 private:
  [[nodiscard]] bool has_time() const {
    if (watch_.token().is_cancelled()) return false;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    return f_.minutes == 0 || passed.count() < 60 * f_.minutes;
  }

  void run_batch(std::uint64_t first, std::uint64_t count) {
    std::vector<fuzz::Finding> found;
    std::mutex mutex;
    verify::for_each_in_jobs(count * engines_.size(), f_.jobs, [&](std::size_t k) {
      if (!has_time()) return;
      const fuzz::Round round = {f_.seed, first + k / engines_.size()};
      const std::string& engine = engines_[k % engines_.size()];
      fuzz::Question question = fuzz::question_of(round);
      if (!f_.questions.empty() && k % engines_.size() == 0)
        fuzz::write_case(fs::path(f_.questions) / fmt::format("{}-{}", round.seed, round.number), question,
                         question.kind, {"fuzz"});
      fuzz::Reply reply = fuzz::ask(question, engine, asking_);
      ++(reply.is_asked ? asked_ : passed_over_);
      if (!reply.broke) return;
      const std::scoped_lock lock(mutex);
      found.push_back({round, engine, std::move(*reply.broke), std::move(question)});
    });
    std::sort(found.begin(), found.end(), [](const fuzz::Finding& a, const fuzz::Finding& b) {
      return std::tie(a.round.number, a.engine) < std::tie(b.round.number, b.engine);
    });
    for (fuzz::Finding& finding : found) report(finding);
  }

  /// The first finding of an engine in a check is shrunk and kept, others are only named.
  void report(fuzz::Finding& finding) {
    ++findings_;
    fmt::print("round {}: {}: {}: {}\n", finding.round.number, finding.engine, finding.broke.check,
               finding.broke.reason);
    fmt::print("  replay: {}\n", fuzz::replay_command(finding));
    if (!known_.emplace(finding.engine, finding.broke.check).second) return;
    const std::size_t before = fuzz::face_count(finding.question);
    finding.question =
        fuzz::shrunken(finding.question, finding.engine, finding.broke.check, asking_, f_.shrink_seconds);
    const fs::path folder = fuzz::keep_finding(finding, f_.keep, oracle_, asking_.limits);
    fmt::print("  {} faces of {}: {}\n", fuzz::face_count(finding.question), before, folder.string());
    std::fflush(stdout);
  }

  const FuzzSettings& f_;
  const OutputSettings& output_;
  fs::path oracle_;
  std::vector<std::string> engines_;
  fuzz::Asking asking_;
  std::atomic<std::uint64_t> asked_ = 0, passed_over_ = 0;
  std::uint64_t findings_ = 0;
  std::set<std::pair<std::string, std::string>> known_;  ///< engines and checks
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  Stopwatch stopwatch_;
  Watch watch_{0};
};

}  // namespace

void add_fuzz_options(CLI::App& verb, FuzzSettings& f, OutputSettings& output) {
  verb.add_option("--seed", f.seed, "Where the sequence of rounds begins")->type_name("S")->capture_default_str();
  auto* rounds = verb.add_option("--rounds", f.rounds, "How many rounds")->type_name("N")->capture_default_str();
  auto* minutes = verb.add_option("--minutes", f.minutes, "Rounds until time is over")->check(CLI::PositiveNumber);
  auto* round =
      verb.add_option("--round", f.only, "This round of the sequence alone: replays a finding")->type_name("K");
  rounds->excludes(minutes)->excludes(round);
  minutes->excludes(round);
  verb.add_option("--case", f.replay, "No rounds: the checks of this case")->type_name("FOLDER")->excludes(round);
  verb.add_option("--check", f.check, "With --case: this check alone")->type_name("NAME");
  add_engine_options(verb, f, "Rounds", "Time for a round; for other engines, for an expression");
  verb.add_option("--keep", f.keep, "Where findings go as cases")->type_name("FOLDER")->capture_default_str();
  verb.add_option("--questions", f.questions, "Write every round as a case, whatever comes of it")->type_name("FOLDER");
  verb.add_option("--shrink-seconds", f.shrink_seconds, "Time to make a finding small; 0: leave it as it is")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  verb.add_flag("-q,--quiet", output.quiet, "No summary");
}

ExitCode run_fuzz(const FuzzSettings& f, const OutputSettings& output) {
  if (!f.replay.empty()) return replay(f);
  return Search(f, output).run();
}
