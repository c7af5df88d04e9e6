#include "strata/combine.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/csg/arena.h"
#include "core/csg/broken_operands.h"
#include "core/csg/early_unions.h"
#include "core/csg/evaluate.h"
#include "core/csg/stopwatch.h"
#include "core/mesh/prepare.h"
#include "core/round/rounding.h"

namespace strata {
namespace {

/// Operands made ready, and their face numbers in the caller's meshes.
class Operands {
 public:
  Operands(std::span<const Operand> given, InputClass input, std::vector<Defect>& notes) {
    prepared_.reserve(given.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
      prepared_.push_back(prepare(given[i], input, i));
      const Prepared& p = prepared_.back();
      notes.insert(notes.end(), p.notes.begin(), p.notes.end());
      const MeshView mesh = p.mesh ? MeshView(*p.mesh) : given[i].mesh;
      input_.add(mesh.vertices, mesh.triangles, given[i].exact, p.bounds);
    }
  }

  [[nodiscard]] const InputComplex& input() const { return input_; }
  /// From faces as they were prepared to those of the caller.
  void restore(std::vector<Source>& sources) const {
    const auto is_renumbered = [](const Prepared& p) { return !p.source_face.empty(); };
    if (std::none_of(prepared_.begin(), prepared_.end(), is_renumbered)) return;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, sources.size(), 1 << 13), [&](const auto& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i) {
        const auto& renumbered = prepared_[sources[i].operand].source_face;
        if (!renumbered.empty()) sources[i].face = renumbered[sources[i].face];
      }
    });
  }

 private:
  static Prepared prepare(const Operand& operand, InputClass input, std::size_t index) {
    if (!operand.exact.empty())
      return operand.is_checked ? Prepared{} : prepare_exact({operand.mesh, operand.exact}, index);
    switch (input) {
      case InputClass::solid:
      case InputClass::overlapping:
        return prepare_closed(operand.mesh, false, index);
      case InputClass::repair:
        return prepare_soup(operand.mesh, index);
    }
    return {};
  }

  std::vector<Prepared> prepared_;
  InputComplex input_;
};

/// The boundary of operands that are what was declared is closed. If it is not, one of them was not: finds out which.
void ensure_closed(const Mesh& result, std::span<const Operand> given, const Options& options) {
  if (chain_is_closed(result)) return;
  refuse_broken_operands(given, options);
  throw LogicError("the boundary of a result is not closed");
}

BooleanResult combine_here(const Rule& rule, std::span<const Operand> given, const Options& options) {
  BooleanResult result;
  Stopwatch watch(result.profile);
  const Monitor monitor(options.cancel, &options.progress);
  monitor.check();
  const Operands operands(given, options.input, result.notes);
  watch.lap("prepare");
  monitor.report(0.05);
  InputComplex input = operands.input();
  PointTable points(input);
  const bool self = options.input != InputClass::solid;
  Boundary boundary = evaluate(input, rule, self, points, monitor, result.profile);
  Stopwatch output(result.profile);
  result.mesh.vertices = round_to_doubles(input, points, boundary, monitor);
  result.mesh.triangles = std::move(boundary.triangles);
  result.sources = std::move(boundary.sources);
  operands.restore(result.sources);
  output.lap("round");
  ensure_closed(result.mesh, given, options);
  output.lap("ensure");
  if (options.exact_vertices) {
    result.exact = exact_positions(input, points, boundary, result.mesh.vertices, monitor);
    output.lap("exact");
  }
  monitor.report(1);
  return result;
}

BooleanResult combine_in_stages(const Rule& rule, std::span<const Operand> given, const Options& options) {
  Profile profile;
  Stopwatch watch(profile);
  const EarlyUnions early(rule, given, options, combine_here);
  watch.lap("unions");
  BooleanResult result = combine_here(rule, early.operands(), options);
  early.restore(result);
  result.profile.seconds.insert(result.profile.seconds.begin(), profile.seconds.begin(), profile.seconds.end());
  return result;
}

/// How many faces of plain solids take as long. Those that are no doubles, or that may cross others of their operand,
/// take ten times as long and more.
std::size_t worth_in_faces(std::span<const Operand> operands, InputClass input) {
  std::size_t worth = 0;
  for (const Operand& o : operands)
    worth += o.mesh.triangles.size() * (o.exact.empty() && input == InputClass::solid ? 1 : 10);
  return worth;
}

BooleanResult combine(const Rule& rule, std::span<const Operand> operands, const Options& options) {
  tbb::task_arena arena = arena_for(options, worth_in_faces(operands, options.input));
  BooleanResult result;
  arena.execute([&] { result = combine_in_stages(rule, operands, options); });
  return result;
}

}  // namespace

BooleanResult combine(Operation operation, std::span<const Operand> operands, const Options& options) {
  if (options.engine != nullptr) return options.engine->combine(operation, operands, options);
  return combine(Rule(operation, static_cast<std::uint32_t>(operands.size())), operands, options);
}

BooleanResult combine(const Formula& formula, std::span<const Operand> operands, const Options& options) {
  if (formula.operands() != operands.size())
    throw std::invalid_argument("the formula is about " + std::to_string(formula.operands()) + " operands, not " +
                                std::to_string(operands.size()));
  if (formula.holds({})) throw std::invalid_argument("the result is not bounded");
  if (options.engine != nullptr) {
    if (options.engine->evaluate == nullptr)
      throw std::invalid_argument(std::string("the engine ") + options.engine->name + " evaluates no formulas");
    return options.engine->evaluate(formula, operands, options);
  }
  return combine(Rule(formula), operands, options);
}

BooleanResult combine(Operation operation, std::span<const MeshView> operands, const Options& options) {
  std::vector<Operand> all;
  for (const MeshView& m : operands) all.push_back({m, {}, false});
  return combine(operation, std::span<const Operand>(all), options);
}

}  // namespace strata
