#include "chain.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "chain_checkpoint.h"
#include "chain_document.h"
#include "chain_marks.h"
#include "chain_operands.h"
#include "chain_run.h"
#include "common/stopwatch.h"
#include "common/watch.h"
#include "report.h"
#include "result_file.h"

namespace {

void check_options(const ChainSettings& chain, const Settings& settings) {
  if (chain.checkpoint == "-" || chain.resume == "-") throw UsageError("a checkpoint is a file, no stream");
  if (!chain.checkpoint.empty() && chain.checkpoint == settings.output)
    throw UsageError("result and checkpoint cannot be the same file");
  if (chain.every != 0 && chain.checkpoint.empty()) throw UsageError("--checkpoint-every needs --checkpoint");
  if (chain.exact_volumes && settings.report.empty()) throw UsageError("--exact-volumes needs --report");
}

void check_streams(const ChainSettings& chain, const ChainDocument& document) {
  if (chain.document != "-") return;
  const auto check = [](const ChainOperand& operand) {
    if (operand.path == "-") throw UsageError("standard input cannot be both the steps and a mesh");
  };
  if (document.start) check(*document.start);
  for (const ChainStep& step : document.steps) check(step.operand);
}

}  // namespace

void add_chain_options(CLI::App& verb, ChainSettings& chain, Settings& settings) {
  verb.add_option("STEPS.json", chain.document, "The start and the steps; - is standard input")->required();
  verb.add_option("--checkpoint", chain.checkpoint,
                  "Keep in this file (XOFF) how far it came: at the end and if stopped")
      ->type_name("FILE");
  verb.add_option("--checkpoint-every", chain.every, "The same after every N steps")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  verb.add_option("--resume", chain.resume, "Go on from a checkpoint; more steps may follow than it was made for")
      ->type_name("FILE");
  verb.add_flag("--exact-volumes", chain.exact_volumes, "Fractions in the report after every step");
  verb.add_flag_callback(
      "--round-transforms", [&settings] { settings.placement = strata::Placement::rounded; },
      "Round transformed vertices to doubles, once; else they are exact");
}

ExitCode run_chain(const ChainSettings& chain, Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  check_options(chain, settings);
  const strata::Format format = output_format(settings);
  Json report = {{"operation", "chain"}, {"document", chain.document}, {"operands", nullptr}, {"result", nullptr}};
  const ChainDocument document = read_chain_document(chain.document, settings);
  check_streams(chain, document);
  if (!chain.checkpoint.empty()) require_writable(chain.checkpoint);
  std::vector<ChainMark> marks;
  if (!chain.checkpoint.empty() || !chain.resume.empty()) marks = marks_of(document);
  std::optional<ChainCheckpoint> from;
  if (!chain.resume.empty()) from = read_checkpoint(chain.resume, marks, settings);

  ChainOperands operands(document, settings);
  ChainRun run(document, marks, chain, settings, watch);
  std::optional<strata::Material> cut_material;
  try {
    operands.read(from ? from->done : 0, !from, from ? from->unit : strata::Unit::none);
    cut_material = settings.attributes.material_among({&operands.materials()});
    run.use_unit(operands.unit());
    report["seconds"]["read"] = stopwatch.lap();
    if (from)
      run.begin(*from);
    else
      run.begin(operands);
    from.reset();
    run.finish(operands);
  } catch (const strata::InputError&) {
    report["operands"] = operands.reports();
    run.add_to(report);
    if (!settings.report.empty()) write_report(settings.report, std::move(report));
    throw;
  }
  report["peak_bytes"] = peak_bytes();
  report["operands"] = operands.reports();
  run.add_to(report);
  const Asked question = []() -> verify::NewCase { throw std::runtime_error("the document itself says all"); };
  if (operands.unit() != strata::Unit::none) settings.unit = strata::name(operands.unit());
  const strata::Solid solid = run.solid(cut_material ? &*cut_material : nullptr);
  return write_result(solid.exact_mesh(), solid.attributes(), format, std::move(report), settings, watch, "chain",
                      question);
}
