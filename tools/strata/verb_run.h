#pragma once
#include <span>
#include <string>
#include <vector>

#include "common/exit_code.h"
#include "common/stopwatch.h"
#include "common/watch.h"
#include "files.h"
#include "report.h"
#include "settings.h"
#include "strata/options.h"
#include "strata/solid.h"
#include "watched_options.h"

/// One run of a verb that reads meshes and makes something else than one solid: reads the operands, watches for stops,
/// keeps the report with the notes of every operand, prints what was counted. Operands that are refused are in the
/// report, too.
class VerbRun {
 public:
  /// Reads the operands. Throws strata::IoError, UsageError.
  VerbRun(const char* verb, const Settings& settings);

  [[nodiscard]] const std::vector<LoadedMesh>& operands() const { return operands_; }
  /// Operand k as a solid; what is resolved is noted. Throws strata::InputError.
  [[nodiscard]] strata::Solid solid(std::size_t k);
  /// What was done with operand k on the way in: printed, and kept for the report.
  void note(std::size_t k, std::span<const strata::Defect> notes);

  /// Calls work(options), with a progress bar; a stop ends it, and says why.
  template <class Work>
  void evaluate(const Work& work);
  /// From here on files are written: it is too late to stop. Throws strata::Cancelled when a stop came before.
  void begin_writing();
  /// Prints the result, member by member, and writes the report. Long members are for the report only.
  [[nodiscard]] ExitCode end(Json result);

 private:
  void write_refusal(const strata::InputError& error);

  const Settings& settings_;
  Watch watch_;
  Stopwatch stopwatch_;
  Json report_;
  std::vector<LoadedMesh> operands_;
  std::vector<std::vector<strata::Defect>> notes_;  ///< per operand
};

template <class Work>
void VerbRun::evaluate(const Work& work) {
  watch_.on_stop(OnStop::ask);
  try {
    ProgressBar bar(settings_.progress, settings_.quiet);
    work(watched_options(settings_, bar, watch_));
  } catch (const strata::InputError& error) {
    write_refusal(error);
    throw;
  } catch (const strata::Cancelled&) {
    watch_.on_stop(OnStop::leave);  // says why
    throw;
  }
}
