#include "chain_document.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <utility>

#include "common/json_choice.h"
#include "common/json_location.h"
#include "common/text_file.h"
#include "json_matrix.h"

namespace {

namespace fs = std::filesystem;

/// What the document and the command line say about all operands.
struct Defaults {
  fs::path directory;
  strata::InputClass input;
  strata::Placement placement;
};

strata::Placement read_placement(const JsonLocation& place) {
  constexpr std::array placements = {strata::Placement::exact, strata::Placement::rounded};
  return placements[place.choice("placement of transforms", {"exact", "rounded"})];
}

ChainOperand read_operand(const JsonLocation& place, const Defaults& defaults) {
  ChainOperand operand;
  operand.place = place.path();
  operand.file = place.at("file").text();
  operand.path = operand.file == "-" ? "-" : (defaults.directory / operand.file).lexically_normal().string();
  operand.input = defaults.input;
  operand.placement = defaults.placement;
  if (const auto label = place.find("label")) operand.label = label->text();
  if (const auto input = place.find("input"))
    operand.input = read_choice(*input, "input class", strata::all_input_classes);
  if (const auto matrix = place.find("transform")) operand.transform = read_matrix(*matrix);
  return operand;
}

strata::Operation read_operation(const JsonLocation& place) {
  if (place.value().is_string())
    if (const auto operation = strata::operation_named(place.value().get<std::string>())) return *operation;
  return read_choice(place, "operation", strata::all_operations);
}

ChainStep read_step(const JsonLocation& place, const Defaults& defaults) {
  place.expect_keys({"operation", "file", "transform", "input", "label"});
  return {read_operation(place.at("operation")), read_operand(place, defaults)};
}

std::optional<ChainOperand> read_start(const JsonLocation& place, const Defaults& defaults) {
  if (place.value().is_null()) return {};
  place.expect_keys({"file", "transform", "input", "label"});
  return read_operand(place, defaults);
}

}  // namespace

std::string ChainOperand::title() const { return label.empty() ? place : fmt::format("{} ({})", place, label); }

ChainDocument read_chain_document(const std::string& path, const Settings& settings) {
  return parse_chain_document(read_text(path), path, settings);
}

ChainDocument parse_chain_document(std::string_view text, const std::string& path, const Settings& settings) {
  ChainDocument document;
  document.name = path == "-" ? "standard input" : path;
  const Json json = parse_json(text, document.name);
  const JsonLocation root(json, document.name);
  root.expect_keys({"transforms", "start", "steps"});
  Defaults defaults{path == "-" ? fs::path() : fs::path(path).parent_path(), settings.input, settings.placement};
  if (const auto place = root.find("transforms"))
    if (read_placement(*place) == strata::Placement::rounded) defaults.placement = strata::Placement::rounded;
  document.start = read_start(root.at("start"), defaults);
  for (const JsonLocation& step : root.at("steps").items()) document.steps.push_back(read_step(step, defaults));
  return document;
}
