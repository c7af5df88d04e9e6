#include "chain_operands.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "files.h"
#include "strata/check.h"
#include "strata/transform.h"
#include "threads.h"

void ChainOperands::read(std::size_t first, bool with_start) {
  if (with_start && document_.start) read(*document_.start);
  for (std::size_t k = first; k < document_.steps.size(); ++k) read(document_.steps[k].operand);
  meshes_.clear();
}

void ChainOperands::read(const ChainOperand& operand) {
  const auto [found, is_new] = solids_.try_emplace({operand.path, operand.input});
  ++found->second.uses;
  if (!is_new) return;
  const LoadedMesh& mesh = mesh_of(operand);
  found->second.solid = make(mesh, operand, operand.input);
  announce(mesh, found->second.solid);
}

void ChainOperands::announce(const LoadedMesh& mesh, const strata::Solid& solid) {
  if (!settings_.report.empty()) reports_.push_back(operand_report(mesh, solid.notes(), settings_));
  print_notes(mesh, solid);
}

void ChainOperands::print_notes(const LoadedMesh& mesh, const strata::Solid& solid) const {
  if (settings_.quiet) return;
  for (const strata::Defect& note : solid.notes())
    fmt::print(stderr, "strata: {}: {}\n", mesh.path, strata::describe(note));
}

const LoadedMesh& ChainOperands::mesh_of(const ChainOperand& operand) {
  const auto found = meshes_.find(operand.path);
  if (found != meshes_.end()) return found->second;
  if (operand.path == "-" && settings_.input_format.empty()) throw UsageError("standard input needs --input-format");
  settings_.operands = {operand.path};
  try {
    return meshes_.emplace(operand.path, std::move(read_operands(settings_).front())).first->second;
  } catch (const strata::IoError& error) {
    throw strata::IoError(document_.name, {}, fmt::format("{}.file: {}", operand.place, error.what()));
  }
}

strata::Solid ChainOperands::make(const LoadedMesh& mesh, const ChainOperand& operand, strata::InputClass input) {
  try {
    return strata::Solid(mesh.mesh, input);
  } catch (const strata::InputError& error) {
    if (!settings_.report.empty()) reports_.push_back(operand_report(mesh, error.defects(), settings_));
    settings_.operands = {fmt::format("{}: {}: {}", document_.name, operand.title(), mesh.path)};
    throw;
  }
}

strata::ExactMesh ChainOperands::moved(const strata::Solid& solid, const ChainOperand& operand) const {
  try {
    return on_threads(settings_,
                      [&] { return strata::transform(solid.exact_mesh(), operand.transform, operand.placement); });
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
  const LoadedMesh image{operand.path + ", transformed", moved(solid, operand)};
  strata::Solid moved_solid = make(image, operand, class_of_image(operand));
  if (operand.placement == strata::Placement::rounded) print_notes(image, moved_solid);
  return moved_solid;
}
