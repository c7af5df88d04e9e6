#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include "common/progress.h"
#include "common/stopwatch.h"
#include "common/watch.h"
#include "layer_file.h"
#include "origin_option.h"
#include "report.h"
#include "scene_input.h"
#include "strata/query.h"
#include "threads.h"
#include "verbs.h"

namespace {

using strata::LayerDecomposition;

bool is_picture(const std::string& path) { return path.ends_with(".glb") || path.ends_with(".GLB"); }

void check_output(const Settings& settings) {
  if (settings.output.empty() || settings.output == "-") return;
  if (strata::format_of(settings.output) != strata::Format::ply && !is_picture(settings.output))
    throw UsageError(fmt::format(
        "layers are written as PLY, or as a picture in glTF; give {} the extension .ply or .glb", settings.output));
}

LayerDecomposition decompose(std::span<const LoadedMesh> operands, const std::optional<strata::Origin>& asked,
                             const Settings& settings, const Watch& watch, Json& seconds) {
  ProgressBar bar(settings.progress, settings.quiet);
  const strata::Progress progress = [&bar](double fraction) { bar.show(fraction); };
  Stopwatch stopwatch;
  const strata::Scene scene = SceneInput(operands, settings).scene();
  seconds["prepare"] = stopwatch.lap();
  const strata::Origin origin = asked ? *asked : strata::choose_origin(scene);
  seconds["origin"] = stopwatch.lap();
  LayerDecomposition layers(scene, origin, strata::Monitor(&watch.token(), &progress));
  seconds["build"] = stopwatch.lap();
  return layers;
}

Json layers_report(const LayerDecomposition& layers) {
  Json counts = Json::array();
  for (std::uint32_t l = 1; l <= layers.layer_count(); ++l) counts.push_back(layers.layer_pieces(l).size());
  std::uint32_t flat = 0;
  for (std::uint32_t f = 0; f < layers.scene().face_count(); ++f) flat += layers.sign(f) == 0;
  return {{"origin", to_json(layers.origin())},
          {"solids", layers.scene().solid_count()},
          {"faces", layers.scene().face_count()},
          {"layers", layers.layer_count()},
          {"faces_per_layer", std::move(counts)},
          {"cuts_at_crossings", layers.cuts_at_crossings()},
          {"cuts_of_cycles", layers.cuts_of_cycles()},
          {"flat_faces", flat},
          {"dominations", layers.domination_count()},
          {"pairs_tested", layers.pairs_tested()},
          {"bytes", layers.bytes()}};
}

/// On standard error where standard output has the layers.
void print_facts(const Json& facts, const Settings& settings) {
  std::FILE* const stream = settings.output == "-" ? stderr : stdout;
  for (const auto& [key, value] : facts.items()) {
    constexpr std::size_t most = 8;
    std::string text = value.dump();
    if (value.is_object()) text = fmt::format("{} {}", value["kind"].get<std::string>(), value["at"].dump());
    if (value.is_array() && value.size() > most) {
      text = "[";
      for (std::size_t i = 0; i < most; ++i) text += value[i].dump() + ",";
      text += "...]";
    }
    fmt::print(stream, "{:17} {}\n", key, text);
  }
}

}  // namespace

ExitCode run_layers(const Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  check_output(settings);
  const auto asked = parse_origin(settings.origin);
  Json report = {{"operation", "layers"}, {"operands", nullptr}, {"result", nullptr}, {"seconds", Json::object()}};
  const std::vector<LoadedMesh> operands = read_operands(settings);
  report["seconds"]["read"] = stopwatch.lap();

  watch.on_stop(OnStop::ask);
  std::optional<LayerDecomposition> layers;
  try {
    on_threads(settings, [&] { layers = decompose(operands, asked, settings, watch, report["seconds"]); });
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["result"] = layers_report(*layers);
  report["peak_bytes"] = peak_bytes();

  watch.on_stop(OnStop::finish);
  stopwatch.lap();
  if (!settings.output.empty())
    on_threads(settings, [&] {
      is_picture(settings.output) ? write_layer_picture(settings.output, *layers)
                                  : write_layers(settings.output, *layers);
    });
  report["seconds"]["write"] = stopwatch.lap();
  if (!settings.quiet && settings.report != "-") print_facts(report["result"], settings);
  if (settings.report.empty()) return ExitCode::ok;
  report["operands"] = operand_reports(operands, settings);
  write_report(settings.report, std::move(report));
  return ExitCode::ok;
}
