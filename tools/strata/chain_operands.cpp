#include "chain_operands.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "common/tell.h"
#include "files.h"
#include "operand_units.h"
#include "strata/carry_attributes.h"
#include "strata/check.h"
#include "strata/transform.h"
#include "threads.h"

void ChainOperands::read(std::size_t first, bool with_start, strata::Unit unit) {
  std::vector<const ChainOperand*> operands;
  if (with_start && document_.start) operands.push_back(&*document_.start);
  for (std::size_t k = first; k < document_.steps.size(); ++k) operands.push_back(&document_.steps[k].operand);
  std::vector<LoadedMesh> meshes;
  std::map<std::string, std::size_t> places;
  if (unit != strata::Unit::none) meshes.push_back({.path = "the solid so far", .mesh = {}, .unit = unit});
  for (const ChainOperand* operand : operands)
    if (places.try_emplace(operand->path, meshes.size()).second) meshes.push_back(load(*operand));
  use_one_unit(meshes, settings_);
  if (!meshes.empty()) unit_ = meshes.front().unit;
  for (const ChainOperand* operand : operands) store(*operand, meshes[places.at(operand->path)]);
}

LoadedMesh ChainOperands::load(const ChainOperand& operand) {
  if (operand.path == "-" && settings_.input_format.empty()) throw UsageError("standard input needs --input-format");
  settings_.operands = {operand.path};
  try {
    LoadedMesh mesh = std::move(read_operands(settings_).front());
    for (const strata::Material& m : mesh.attributes.materials) materials_.materials.push_back(m);
    return mesh;
  } catch (const strata::IoError& error) {
    throw strata::IoError(document_.name, {}, fmt::format("{}.file: {}", operand.place, error.what()));
  }
}

void ChainOperands::store(const ChainOperand& operand, const LoadedMesh& mesh) {
  const auto [found, is_new] = solids_.try_emplace({operand.path, operand.input});
  ++found->second.uses;
  if (!is_new) return;
  settings_.operands = {operand.path};
  found->second.solid = make(mesh, operand, operand.input);
  announce(mesh, found->second.solid);
}

void ChainOperands::announce(const LoadedMesh& mesh, const strata::Solid& solid) {
  if (!settings_.report.empty()) reports_.push_back(operand_report(mesh, solid.notes(), settings_));
  print_notes(mesh, solid);
}

void ChainOperands::print_notes(const LoadedMesh& mesh, const strata::Solid& solid) const {
  if (settings_.quiet) return;
  for (const strata::Defect& note : solid.notes()) tell("strata: {}: {}\n", mesh.path, strata::describe(note));
}

strata::Solid ChainOperands::make(const LoadedMesh& mesh, const ChainOperand& operand, strata::InputClass input) {
  try {
    return with_attributes_of(mesh, strata::Solid(mesh.mesh, input));
  } catch (const strata::InputError& error) {
    if (!settings_.report.empty()) reports_.push_back(operand_report(mesh, error.defects(), settings_));
    settings_.operands = {fmt::format("{}: {}: {}", document_.name, operand.title(), mesh.path)};
    throw;
  }
}

LoadedMesh ChainOperands::moved(const strata::Solid& solid, const ChainOperand& operand) const {
  LoadedMesh image{.path = operand.path + ", transformed", .mesh = {}};
  try {
    image.mesh = on_threads(
        settings_, [&] { return strata::transform(solid.exact_mesh(), operand.transform, operand.placement); });
    image.attributes = strata::transform(solid.attributes(), operand.transform);
    return image;
  } catch (const std::overflow_error& error) {
    throw strata::IoError(document_.name, {}, fmt::format("{}.transform: {}", operand.place, error.what()));
  }
}

namespace {

/// What rounding folds over is resolved where that was asked for; it is no soup any more.
strata::InputClass class_of_image(const ChainOperand& operand) {
  using strata::InputClass;
  if (operand.placement == strata::Placement::exact) return InputClass::solid;
  const bool is_soup = operand.input == InputClass::repair || operand.input == InputClass::soup;
  return is_soup ? InputClass::overlapping : operand.input;
}

}  // namespace

strata::Solid ChainOperands::take(const ChainOperand& operand) {
  settings_.operands = {fmt::format("{}: the solid before {}", document_.name, operand.place),
                        fmt::format("{}: {}: {}", document_.name, operand.title(), operand.path)};
  const auto found = solids_.find({operand.path, operand.input});
  const strata::Solid solid = found->second.solid;
  if (--found->second.uses == 0) solids_.erase(found);
  if (operand.transform.is_identity()) return solid;
  const LoadedMesh image = moved(solid, operand);
  strata::Solid moved_solid = make(image, operand, class_of_image(operand));
  if (operand.placement == strata::Placement::rounded) print_notes(image, moved_solid);
  return moved_solid;
}
