#include "verb_run.h"

#include <fmt/format.h>

#include <utility>

#include "common/tell.h"

VerbRun::VerbRun(const char* verb, const Settings& settings)
    : settings_(settings),
      watch_(settings.timeout),
      report_({{"operation", verb}, {"operands", Json::array()}, {"result", nullptr}, {"seconds", Json::object()}}),
      operands_(read_operands(settings)),
      notes_(operands_.size()) {
  report_["seconds"]["read"] = stopwatch_.lap();
}

strata::Solid VerbRun::solid(std::size_t k) {
  strata::Solid solid = make_solid(operands_, k, settings_);  // prints its notes
  notes_[k] = solid.notes();
  return solid;
}

void VerbRun::note(std::size_t k, std::span<const strata::Defect> notes) {
  notes_[k].assign(notes.begin(), notes.end());
  if (settings_.quiet) return;
  for (const strata::Defect& note : notes) tell("strata: {}: {}\n", operands_[k].path, strata::describe(note));
}

void VerbRun::begin_writing() {
  report_["seconds"]["evaluate"] = stopwatch_.lap();
  report_["peak_bytes"] = peak_bytes();
  watch_.on_stop(OnStop::finish);
}

ExitCode VerbRun::end(Json result) {
  report_["seconds"]["write"] = stopwatch_.lap();
  constexpr std::size_t longest = 100;
  if (!settings_.quiet && settings_.report != "-")
    for (const auto& [key, value] : result.items())
      if (const std::string text = value.dump(); text.size() < longest)
        fmt::print(settings_.output == "-" ? stderr : stdout, "{:12} {}\n", key, text);
  if (settings_.report.empty()) return ExitCode::ok;
  report_["result"] = std::move(result);
  for (std::size_t k = 0; k < operands_.size(); ++k)
    report_["operands"].push_back(operand_report(operands_[k], notes_[k], settings_));
  write_report(settings_.report, std::move(report_));
  return ExitCode::ok;
}

void VerbRun::write_refusal(const strata::InputError& error) {
  if (settings_.report.empty()) return;
  if (error.operand() < notes_.size()) notes_[error.operand()] = error.defects();
  for (std::size_t k = 0; k < operands_.size(); ++k)
    report_["operands"].push_back(operand_report(operands_[k], notes_[k], settings_));
  write_report(settings_.report, std::move(report_));
}
