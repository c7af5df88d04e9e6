#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/progress.h"
#include "common/stopwatch.h"
#include "common/watch.h"
#include "files.h"
#include "named_operands.h"
#include "report.h"
#include "strata/expression.h"
#include "strata/measure.h"
#include "threads.h"
#include "verbs.h"
#include "viewer_page.h"
#include "watched_options.h"

namespace {

/// Exact volumes of more digits are told by the nearest double alone.
constexpr std::size_t most_digits = 40;

std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return digits;
}

std::vector<std::pair<std::string, std::string>> facts_of(const strata::Solid& solid) {
  const double nearest = strata::nearest_volume(solid.exact_mesh());
  std::vector<std::pair<std::string, std::string>> facts{{"triangles", grouped(solid.mesh().triangles.size())},
                                                         {"volume", fmt::format("{}", nearest)}};
  const std::string exact = solid.volume().str();
  if (exact.size() <= most_digits && exact != facts.back().second) facts.emplace_back("exactly", exact);
  facts.emplace_back("area", fmt::format("{}", solid.area()));
  return facts;
}

/// The parts: all operands, and before them the value of the expression, beside which operands are hidden at first.
class Viewer {
 public:
  Viewer(const Settings& settings, const std::vector<NamedOperand>& names, const std::vector<LoadedMesh>& meshes)
      : settings_(settings), names_(names), meshes_(meshes) {}

  std::vector<ViewerPart> parts(const strata::Options& options) const {
    std::vector<strata::Solid> solids;
    for (std::size_t k = 0; k < meshes_.size(); ++k) solids.push_back(make_solid(meshes_, k, settings_));
    std::vector<ViewerPart> parts;
    if (!settings_.expression.empty()) {
      strata::Solid value = evaluated(parsed(solids), options);
      auto facts = facts_of(value);
      parts.push_back({settings_.expression, std::move(value), std::move(facts)});
    }
    for (std::size_t k = 0; k < solids.size(); ++k)
      parts.push_back({name_of(k), solids[k], facts_of(solids[k]), settings_.expression.empty()});
    return parts;
  }

 private:
  static strata::Solid evaluated(const strata::Expression& expression, const strata::Options& options) {
    try {
      return expression.evaluate(options);
    } catch (const std::invalid_argument& error) {
      throw UsageError(error.what());  // the value is not bounded
    }
  }

  [[nodiscard]] std::string name_of(std::size_t k) const {
    const std::string file = std::filesystem::path(names_[k].path).filename().string();
    return settings_.expression.empty() ? file : names_[k].name + " = " + file;
  }

  [[nodiscard]] strata::Expression parsed(const std::vector<strata::Solid>& solids) const {
    return strata::parse_expression(settings_.expression, [&](const std::string& name) {
      const auto at = std::find_if(names_.begin(), names_.end(), [&](const auto& o) { return o.name == name; });
      if (at == names_.end()) throw std::out_of_range(name);
      return solids[static_cast<std::size_t>(at - names_.begin())];
    });
  }

  const Settings& settings_;
  const std::vector<NamedOperand>& names_;
  const std::vector<LoadedMesh>& meshes_;
};

/// Before any file is read.
void check_expression(const std::string& text, const std::vector<NamedOperand>& names) {
  try {
    (void)strata::parse_expression(text, [&](const std::string& name) {
      if (std::none_of(names.begin(), names.end(), [&](const auto& o) { return o.name == name; }))
        throw std::out_of_range(name);
      return strata::Solid();
    });
  } catch (const strata::ParseError& error) {
    throw UsageError(fmt::format("{}\n  {}\n  {:>{}}", error.what(), text, '^', error.position() + 1));
  }
}

std::string title_of(const Settings& settings, const std::vector<NamedOperand>& names) {
  if (!settings.expression.empty()) return settings.expression;
  std::string title;
  for (const NamedOperand& o : names)
    title += (title.empty() ? "" : ", ") + std::filesystem::path(o.path).filename().string();
  return title;
}

}  // namespace

ExitCode run_view(Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  const std::vector<NamedOperand> names = named_operands(settings.bindings);
  if (!settings.expression.empty()) check_expression(settings.expression, names);
  settings.operands.clear();
  for (const NamedOperand& o : names) settings.operands.push_back(o.path);
  check_streams(settings);
  const std::vector<LoadedMesh> meshes = read_operands(settings);
  Json report = {{"operation", "view"}, {"operands", Json::array()}, {"seconds", {{"read", stopwatch.lap()}}}};
  for (const LoadedMesh& mesh : meshes) report["operands"].push_back(mesh.path);

  watch.on_stop(OnStop::ask);
  ProgressBar bar(settings.progress, settings.quiet);
  std::string page;
  try {
    page = on_threads(settings, [&] {
      const auto parts = Viewer(settings, names, meshes).parts(watched_options(settings, bar, watch));
      report["seconds"]["evaluate"] = stopwatch.lap();
      return viewer_page(title_of(settings, names), parts, strata::Monitor(&watch.token()));
    });
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["seconds"]["page"] = stopwatch.lap();
  watch.on_stop(OnStop::finish);
  write_text(settings.output, page);
  report["bytes"] = page.size();
  if (!settings.report.empty()) write_report(settings.report, std::move(report));
  return ExitCode::ok;
}
