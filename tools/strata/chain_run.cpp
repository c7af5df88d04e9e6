#include "chain_run.h"

#include <fmt/format.h>

#include "common/progress.h"
#include "common/stopwatch.h"
#include "common/tell.h"
#include "reproduction.h"
#include "strata/errors.h"

namespace {

Json label_of(const ChainOperand& operand) { return operand.label.empty() ? Json(nullptr) : Json(operand.label); }

/// A step as a case: the solid before it and its tool.
verify::NewCase asked(const strata::Solid& before, const ChainStep& step, const strata::Solid& tool) {
  verify::NewCase c;
  c.expression = joined_expression(step.operation, 2);
  c.operands = {{"s0", &before.exact_mesh()}, {"s1", &tool.exact_mesh()}};
  return c;
}

}  // namespace

ChainRun::ChainRun(const ChainDocument& document, const std::vector<ChainMark>& marks, const ChainSettings& chain,
                   const Settings& settings, Watch& watch)
    : document_(document), marks_(marks), chain_(chain), settings_(settings), watch_(watch) {}

void ChainRun::begin(const ChainCheckpoint& from) {
  solid_in_steps_ = strata::IncrementalSolid(from.solid);
  done_ = from.done;
  resumed_ = {{"checkpoint", chain_.resume}, {"steps_done", done_}};
  resumed_.update(facts());
}

void ChainRun::begin(ChainOperands& operands) {
  const std::optional<ChainOperand>& start = document_.start;
  if (start) solid_in_steps_ = strata::IncrementalSolid(operands.take(*start));
  start_ = {{"label", start ? label_of(*start) : Json(nullptr)}, {"file", start ? Json(start->file) : Json(nullptr)}};
  start_.update(facts());
}

void ChainRun::finish(ChainOperands& operands) {
  ProgressBar bar(settings_.progress, settings_.quiet);
  strata::Options options;
  options.threads = settings_.threads;
  options.cancel = &watch_.token();
  options.progress = [&](double fraction) {
    bar.show((static_cast<double>(done_) + fraction) / static_cast<double>(document_.steps.size()));
  };
  try {
    while (done_ < document_.steps.size()) do_step(document_.steps[done_], operands, options);
    if (!chain_.checkpoint.empty()) save();
    watch_.on_stop(OnStop::leave);
  } catch (const strata::Cancelled&) {
    watch_.hold();
    if (chain_.checkpoint.empty()) throw strata::Cancelled(watch_.reason());
    save();
    throw strata::Cancelled(fmt::format("{}; {} of {} steps are done and in {}", watch_.reason(), done_,
                                        document_.steps.size(), chain_.checkpoint));
  }
}

// Only the engine can be stopped; what is done beside is short.
void ChainRun::do_step(const ChainStep& step, ChainOperands& operands, const strata::Options& options) {
  watch_.on_stop(OnStop::ask);
  Stopwatch stopwatch;
  strata::Solid before;
  const strata::Solid tool = operands.take(step.operand);
  solid_in_steps_ = with_reproduction([&] { return asked(before = solid_in_steps_.solid(), step, tool); }, "chain",
                                      settings_, [&] { return solid_in_steps_.with(step.operation, tool, options); });
  const double seconds = stopwatch.lap();
  watch_.hold();
  ++done_;
  options.progress(0);
  evaluating_ += seconds;
  if (!settings_.report.empty()) {
    rows_.push_back({{"index", done_ - 1},
                     {"label", label_of(step.operand)},
                     {"operation", name(step.operation)},
                     {"file", step.operand.file},
                     {"seconds", seconds}});
    rows_.back().update(facts());
  }
  if (chain_.every != 0 && done_ % chain_.every == 0 && done_ < document_.steps.size()) save();
}

Json ChainRun::facts() {
  Json row = {{"triangles", solid_in_steps_.triangle_count()}, {"volume", solid_in_steps_.volume()}};
  if (!chain_.exact_volumes) return row;
  Stopwatch stopwatch;
  row["volume_exact"] = solid_in_steps_.solid().volume().str();
  measuring_ += stopwatch.lap();
  return row;
}

strata::Solid ChainRun::solid(const strata::Material* cut_material) const {
  strata::Options options;
  options.threads = settings_.threads;
  options.cut_material = cut_material;
  return solid_in_steps_.solid(options);
}

void ChainRun::save() {
  if (saved_ == done_) return;
  Stopwatch stopwatch;
  const strata::Solid solid = solid_in_steps_.solid();
  if (saves_ == 0 && !settings_.quiet && !solid.attributes().empty())
    tell(
        "strata: {}: note: a checkpoint keeps no attributes; a chain resumed from it has those of later "
        "steps only\n",
        chain_.checkpoint);
  write_checkpoint(chain_.checkpoint, {done_, solid, unit_}, marks_, settings_);
  saving_ += stopwatch.lap();
  saved_ = done_;
  ++saves_;
}

void ChainRun::add_to(Json& report) const {
  report["start"] = start_;
  report["resumed"] = resumed_;
  report["steps"] = rows_;
  report["checkpoints"] =
      chain_.checkpoint.empty() ? Json(nullptr) : Json{{"path", chain_.checkpoint}, {"written", saves_}};
  report["seconds"]["evaluate"] = evaluating_;
  if (chain_.exact_volumes) report["seconds"]["volumes"] = measuring_;
  if (!chain_.checkpoint.empty()) report["seconds"]["checkpoints"] = saving_;
}
