#include "model_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/tell.h"
#include "eval.h"
#include "openscad_program.h"
#include "planar_input.h"
#include "rounded_region.h"
#include "strata/errors.h"
#include "strata/openscad.h"
#include "watched_options.h"

namespace {

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension.empty() ? extension : extension.substr(1);
}

/// The format of a shape that -o and --format ask for.
std::string shape_format(const Settings& settings) {
  std::string format = settings.output_format.empty() ? extension_of(settings.output) : settings.output_format;
  if (format == "dxf" || strata::planar::planar_format_named(format)) return format;
  throw UsageError(
      fmt::format("{} is a shape in the plane: write it as .svg, .dxf, .wkt or .geojson", settings.expression));
}

void refuse_shape_format(const Settings& settings) {
  const std::string format = settings.output_format.empty() ? extension_of(settings.output) : settings.output_format;
  if (format == "dxf" || strata::planar::planar_format_named(format))
    throw UsageError(fmt::format("{} is a solid, or empty: write it as a mesh", settings.expression));
}

/// SVG has y downwards.
strata::planar::Region upside_down(const strata::planar::Region& region) {
  strata::planar::LoopsBuilder loops;
  for (std::uint32_t l = 0; l < region.loops.size(); ++l) {
    for (const std::uint32_t v : region.loops.loop(l)) {
      strata::planar::RationalPlacement p = strata::planar::exact_position(region.loops.places, v);
      p[1] = -p[1];
      loops.add_vertex(std::move(p));
    }
    loops.end_loop();
  }
  return strata::planar::fill(loops.finish());
}

std::string text_of(const strata::planar::Region& region, const std::string& format, const Settings& settings) {
  using strata::planar::Coordinates;
  if (format == "dxf") return strata::to_dxf(region);
  const auto known = *strata::planar::planar_format_named(format);
  const auto coordinates = settings.exact ? Coordinates::exact : Coordinates::nearest;
  if (known == strata::planar::PlanarFormat::svg)
    return strata::planar::to_text(upside_down(region), known, coordinates);
  return strata::planar::to_text(region, known, coordinates);
}

ExitCode write_shape(const strata::planar::Region& shape, Json report, const Settings& settings, Watch& watch,
                     Stopwatch& stopwatch) {
  const std::string format = shape_format(settings);
  if (settings.exact && format != "wkt") throw UsageError("--exact is for WKT: other formats have no quotients");
  const OutputRegion written = cancellable(
      watch, settings, [&](const strata::Monitor& monitor) { return output_region(shape, settings, monitor); });
  report["seconds"]["round"] = stopwatch.lap();
  watch.on_stop(OnStop::finish);
  write_text(settings.output, text_of(written.rounded.region, format, settings));
  report["seconds"]["write"] = stopwatch.lap();
  report["peak_bytes"] = peak_bytes();
  if (!settings.report.empty()) {
    report["shape"] = region_facts(shape);
    write_report(settings.report, std::move(report));
  }
  return report_conflicts(written, settings);
}

strata::CsgModel read_model(const Settings& settings, Watch& watch) {
  ProgressBar bar(settings.progress, settings.quiet);
  strata::CsgOptions options;
  options.placement = settings.placement;
  options.any_path = settings.any_path;
  options.fonts = settings.fonts;
  options.evaluation = watched_options(settings, bar, watch);
  watch.on_stop(OnStop::ask);
  try {
    if (extension_of(settings.expression) == "csg") return strata::read_csg_file(settings.expression, options);
    options.folder = std::filesystem::path(settings.expression).parent_path().string();
    if (options.folder.empty()) options.folder = ".";
    const std::string text = csg_of(settings.expression, settings.definitions, settings.openscad, watch);
    return strata::read_csg(text, settings.expression, options);
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  } catch (const strata::CsgError& error) {
    throw strata::IoError(error.file(), {error.line(), {}},
                          fmt::format("column {}: {}", error.column(), error.reason()));
  }
}

/// About solids with the attributes that are wanted.
strata::Expression with_chosen_attributes(const strata::Expression& expression, const AttributeSettings& settings) {
  if (settings.names == std::vector<std::string>{"all"}) return expression;
  return expression.with_solids([&](const strata::Solid& solid) {
    return solid.attributes().empty() ? solid : solid.with_attributes(settings.chosen(solid.attributes()));
  });
}

Json to_json(const std::vector<strata::CsgNode>& nodes) {
  std::vector<strata::CsgNode> slowest = nodes;
  std::stable_sort(slowest.begin(), slowest.end(), [](const auto& a, const auto& b) { return a.seconds > b.seconds; });
  Json list = Json::array();
  for (const auto& n : slowest) list.push_back({{"name", n.name}, {"line", n.line}, {"seconds", n.seconds}});
  return list;
}

}  // namespace

ExitCode run_model_file(Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  Json report = {{"operation", "eval"}, {"expression", nullptr}, {"operands", Json::array()}, {"result", nullptr}};
  if (settings.output.empty()) throw UsageError("-o is missing");
  const strata::CsgModel model = read_model(settings, watch);
  if (!settings.quiet)
    for (const std::string& note : model.notes) tell("strata: {}: note: {}\n", settings.expression, note);
  report["seconds"]["read"] = stopwatch.lap();
  report["nodes"] = to_json(model.nodes);
  if (model.shape) return write_shape(*model.shape, std::move(report), settings, watch, stopwatch);
  refuse_shape_format(settings);
  const strata::Expression expression = with_chosen_attributes(model.expression, settings.attributes);
  return evaluate_and_write(expression, Json::array(), std::move(report), settings, watch, stopwatch,
                            [&]() -> verify::NewCase {
                              throw std::runtime_error("a model is its own reproduction: " + settings.expression);
                            });
}
