#include "extensions/openscad/model.h"

#include <tbb/parallel_for.h>
#include <tbb/spin_mutex.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/csg/arena.h"
#include "extensions/openscad/plan.h"
#include "extensions/openscad/solid_operations.h"

namespace strata::openscad {
namespace {

/// Takes the steps of a plan level by level, those of a level in parallel.
class Evaluation {
 public:
  Evaluation(std::vector<Step> steps, const CsgOptions& options, Report& report)
      : steps_(std::move(steps)), options_(options), report_(report), outcomes_(steps_.size()) {
    inner_ = options.evaluation;
    inner_.progress = {};
  }

  CsgModel run() {
    arena_for(options_.evaluation).execute([&] {
      for (const auto& level : levels()) take(level);
    });
    for (const Outcome& o : outcomes_)
      if (o.notes) report_.absorb(*o.notes);
    const Part& whole = outcomes_.front().part;
    CsgModel model{whole.is_solid() ? whole.solid() : Expression::any({}), {}, std::nullopt, {}};
    if (whole.is_shape()) model.shape = whole.shape();
    for (std::size_t i = 1; i < steps_.size(); ++i)
      if (is_worth_telling(steps_[i]))
        model.nodes.push_back({std::string(steps_[i].node->name), steps_[i].node->place.line, outcomes_[i].seconds});
    return model;
  }

 private:
  struct Outcome {
    Part part;
    std::optional<Report> notes;
    double seconds = 0;
    std::exception_ptr error;
  };
  using Level = std::vector<std::uint32_t>;

  static bool is_worth_telling(const Step& s) { return s.operation && s.kind >= NodeKind::hull; }

  [[nodiscard]] std::vector<Level> levels() {
    std::vector<Level> levels;
    for (std::uint32_t i = 0; i < steps_.size(); ++i) {
      if (!steps_[i].operation) {
        outcomes_[i].part = std::move(steps_[i].part);
        continue;
      }
      levels.resize(std::max<std::size_t>(levels.size(), steps_[i].level + 1));
      levels[steps_[i].level].push_back(i);
      ++total_;
    }
    return levels;
  }

  void take(const Level& level) {
    Monitor(options_.evaluation.cancel).check();
    tbb::parallel_for(std::size_t{0}, level.size(), [&](std::size_t k) { take(level[k]); });
    for (const std::uint32_t i : level)
      if (outcomes_[i].error) std::rethrow_exception(outcomes_[i].error);
    for (const std::uint32_t i : level)
      for (const std::uint32_t child : steps_[i].children)
        if (--steps_[child].uses == 0) outcomes_[child].part = {};
  }

  void take(std::uint32_t i) {
    Outcome& outcome = outcomes_[i];
    const auto start = std::chrono::steady_clock::now();
    try {
      std::vector<Part> children;
      for (const std::uint32_t child : steps_[i].children) children.push_back(outcomes_[child].part);
      Report notes(report_.file());
      outcome.part = steps_[i].operation(std::move(children), inner_, notes);
      if (steps_[i].is_evaluated && outcome.part.is_solid()) add_value(outcome.part);
      if (!notes.is_empty()) outcome.notes = std::move(notes);
    } catch (const InputError& e) {
      outcome.error = failure(steps_[i], e);
    } catch (const std::overflow_error& e) {
      outcome.error = failure(steps_[i], e);
    } catch (const std::length_error& e) {
      outcome.error = failure(steps_[i], e);
    } catch (...) {
      outcome.error = std::current_exception();
    }
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const tbb::spin_mutex::scoped_lock lock(mutex_);
    ++done_;
    if (const Progress& progress = options_.evaluation.progress)
      progress(static_cast<double>(done_) / static_cast<double>(total_));
  }

  void add_value(Part& part) const {
    try {
      part = part.with_value(evaluated(part, inner_));
    } catch (const std::overflow_error&) {
      // A coordinate is beyond all doubles here, and may not be where the part is moved to: each step evaluates it.
    }
  }

  [[nodiscard]] std::exception_ptr failure(const Step& step, const std::exception& e) const {
    try {
      report_.fail(step.node->place, std::string(step.node->name) + ": " + e.what());
    } catch (...) {
      return std::current_exception();
    }
  }

  std::vector<Step> steps_;
  const CsgOptions& options_;
  Options inner_;
  Report& report_;
  std::vector<Outcome> outcomes_;
  std::size_t total_ = 0, done_ = 0;
  tbb::spin_mutex mutex_;
};

}  // namespace

CsgModel model_of(const std::vector<SyntaxNode>& nodes, const CsgOptions& options, Report& report) {
  return Evaluation(plan_of(nodes, options, report), options, report).run();
}

}  // namespace strata::openscad
