#include "eval.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/stopwatch.h"
#include "extensions.h"
#include "files.h"
#include "report.h"
#include "reproduction.h"
#include "result_file.h"
#include "strata/errors.h"
#include "strata/expression.h"
#include "verbs.h"
#include "watched_options.h"

namespace {

/// The expression, as the command line or a model file has it, and what the report says about its parts.
struct Input {
  std::vector<LoadedMesh> operands;
  std::vector<std::string> names;  ///< of the operands
  std::optional<strata::Expression> expression;
};

/// NAME=FILE arguments.
std::map<std::string, std::string> paths_by_name(const std::vector<std::string>& bindings) {
  std::map<std::string, std::string> paths;
  for (const std::string& b : bindings) {
    const std::size_t equals = b.find('=');
    if (equals == 0 || equals == std::string::npos || equals + 1 == b.size())
      throw UsageError(fmt::format("expected NAME=FILE, found '{}'", b));
    if (!paths.emplace(b.substr(0, equals), b.substr(equals + 1)).second)
      throw UsageError(fmt::format("'{}' is given twice", b.substr(0, equals)));
  }
  return paths;
}

[[noreturn]] void fail_at(const std::string& text, const strata::ParseError& error) {
  throw UsageError(fmt::format("{}\n  {}\n  {:>{}}", error.what(), text, '^', error.position() + 1));
}

/// Names that the text uses, each once, in order. Checks the text before any file is read.
std::vector<std::string> names_in(const std::string& text, const std::map<std::string, std::string>& paths) {
  std::vector<std::string> names;
  try {
    (void)strata::parse_expression(text, [&](const std::string& name) {
      (void)paths.at(name);
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
      return strata::Solid();
    });
  } catch (const strata::ParseError& error) {
    fail_at(text, error);
  }
  for (const auto& [name, path] : paths)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw UsageError(fmt::format("the expression has no '{}'", name));
  return names;
}

bool is_model(const Settings& settings) {
  std::string extension = std::filesystem::path(settings.expression).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return (extension == ".csg" || extension == ".scad") && settings.bindings.empty();
}

Input read_expression(Settings& settings) {
  const auto paths = paths_by_name(settings.bindings);
  const std::vector<std::string> names = names_in(settings.expression, paths);
  settings.operands.clear();
  for (const std::string& name : names) settings.operands.push_back(paths.at(name));
  check_streams(settings);
  Input input{read_operands(settings), names, {}};
  settings.unit = with_unit_of(input.operands, settings).unit;
  std::map<std::string, strata::Solid> solids;
  for (std::size_t k = 0; k < names.size(); ++k) solids[names[k]] = make_attributed_solid(input.operands, k, settings);
  input.expression =
      strata::parse_expression(settings.expression, [&](const std::string& name) { return solids.at(name); });
  return input;
}

/// Null where a form has more solids than anyone wants to read about.
template <class Form>
Json form_report(const Form& form) {
  constexpr std::size_t most = 10'000, readable = 100;
  try {
    const strata::Expression e = form(most);
    return {{"solids", e.size()}, {"text", e.size() <= readable ? Json(e.text()) : Json(nullptr)}};
  } catch (const std::length_error&) {
    return nullptr;
  }
}

Json expression_report(const strata::Expression& e) {
  Json primitives = Json::array();
  for (const auto& p : e.primitives())
    primitives.push_back(
        {{"name", p.name}, {"positive", p.positive}, {"negative", p.negative}, {"matters", p.matters}});
  return {{"solids", e.size()},
          {"positive_form", form_report([&](std::size_t most) { return e.positive_form(most); })},
          {"disjunctive_form", form_report([&](std::size_t most) { return e.disjunctive_form(most); })},
          {"primitives", std::move(primitives)}};
}

std::optional<strata::Material> material_for_cuts(const strata::Expression& expression, const Settings& settings) {
  if (settings.attributes.cut_material.empty()) return std::nullopt;
  const auto primitives = expression.primitives();
  std::vector<const strata::Attributes*> lists;
  for (const auto& p : primitives) lists.push_back(&p.solid.attributes());
  return settings.attributes.material_among(lists);
}

strata::Solid evaluate(const strata::Expression& expression, const Settings& settings, const Watch& watch) {
  ProgressBar bar(settings.progress, settings.quiet);
  strata::Options options = watched_options(settings, bar, watch);
  const std::optional<strata::Material> cut_material = material_for_cuts(expression, settings);
  if (cut_material) options.cut_material = &*cut_material;
  try {
    return expression.evaluate(options);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

/// What was asked, as a case.
verify::NewCase asked(const Input& input, const Settings& settings) {
  verify::NewCase c;
  c.expression = settings.expression;
  c.input = settings.input;
  for (std::size_t k = 0; k < input.names.size(); ++k) c.operands.emplace_back(input.names[k], &input.operands[k].mesh);
  return c;
}

}  // namespace

ExitCode evaluate_and_write(const strata::Expression& expression, const Json& operands, Json report, Settings& settings,
                            Watch& watch, Stopwatch& stopwatch, const Asked& question) {
  const strata::Format format = output_format(settings);
  watch.on_stop(OnStop::ask);
  strata::Solid solid;
  try {
    solid = with_reproduction(question, "eval", settings, [&] { return evaluate(expression, settings, watch); });
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  report["seconds"]["evaluate"] = stopwatch.lap();
  report["peak_bytes"] = peak_bytes();
  if (!settings.report.empty()) {
    report["expression"] = expression_report(expression);
    report["operands"] = operands;
  }
  return write_result(solid.exact_mesh(), solid.attributes(), format, std::move(report), settings, watch, "eval",
                      question);
}

ExitCode run_eval(Settings& settings) {
  if (is_model(settings)) return run_model(settings);
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  Json report = {{"operation", "eval"}, {"expression", nullptr}, {"operands", nullptr}, {"result", nullptr}};
  (void)output_format(settings);
  const Input input = read_expression(settings);
  report["seconds"]["read"] = stopwatch.lap();
  const Json operands = settings.report.empty() ? Json() : Json(operand_reports(input.operands, settings));
  return evaluate_and_write(*input.expression, operands, std::move(report), settings, watch, stopwatch,
                            [&] { return asked(input, settings); });
}
