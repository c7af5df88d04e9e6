#include "strata/combine.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/attributes/carry.h"
#include "core/csg/arena.h"
#include "core/csg/boolean.h"
#include "core/csg/early_unions.h"
#include "core/csg/found_class.h"
#include "core/csg/measures.h"
#include "core/csg/round_to_solid.h"
#include "core/csg/stopwatch.h"

namespace strata {
namespace {

bool have_attributes(std::span<const Operand> operands) {
  return std::any_of(operands.begin(), operands.end(), [](const Operand& o) { return o.attributes != nullptr; });
}

/// Some operands of unions are united first, then all.
BooleanResult combine_in_arena(const Rule& rule, std::span<const Operand> given, const Options& options,
                               KnownOperands known) {
  Profile profile;
  Stopwatch watch(profile);
  const EarlyUnions early(rule, given, options, [](const Rule& r, std::span<const Operand> some, const Options& o) {
    return boolean(r, some, o);
  });
  watch.lap("early_unions");
  for (std::size_t i = 0; i < known.prepared.size(); ++i)
    if (early.is_replaced(i)) known.prepared[i].reset();
  BooleanResult result = boolean(rule, early.operands(), options, std::move(known));
  early.restore(result);
  result.profile.seconds.insert(result.profile.seconds.begin(), profile.seconds.begin(), profile.seconds.end());
  return result;
}

/// Evaluates with the class that operands of class `automatic` turn out to have, and what was found on the way.
template <class Evaluate>
BooleanResult with_found_class(std::span<const Operand> operands, const Options& options, const Evaluate& evaluate) {
  if (options.input != InputClass::automatic) return evaluate(options, KnownOperands());
  Profile profile;
  FoundClass found;
  Options now = options;
  // One operand is given to be resolved, several are mostly solids.
  const InputClass expected = operands.size() == 1 ? options.input : InputClass::solid;
  arena_for(options, worth_in_faces(operands, expected)).execute([&] {
    Stopwatch watch(profile);
    found = find_class(operands, Monitor(options.cancel));
    watch.lap("inspect");
  });
  now.input = found.input;
  BooleanResult result = evaluate(now, std::move(found.known));
  result.notes.insert(result.notes.begin(), found.notes.begin(), found.notes.end());
  result.profile.seconds.insert(result.profile.seconds.begin(), profile.seconds.begin(), profile.seconds.end());
  return result;
}

/// With attributes it matters which of several coincident faces is kept. About solids, operations keep the right one.
Rule with_keepers(const Rule& rule, std::span<const Operand> operands, const Options& options, bool is_formula) {
  const bool is_clear = options.input == InputClass::solid && !is_formula;
  return is_clear || !have_attributes(operands) ? rule : rule.by_first_keeper();
}

BooleanResult combine(const Rule& rule, std::span<const Operand> operands, const Options& options,
                      KnownOperands known) {
  const Arena arena = arena_for(options, worth_in_faces(operands, options.input));
  BooleanResult result;
  arena.execute([&] { result = combine_in_arena(rule, operands, options, std::move(known)); });
  return result;
}

/// What another engine evaluates is measured and rounded from exact vertices.
template <class Evaluate>
BooleanResult by_engine(const Options& options, const Evaluate& evaluate) {
  Options exact = options;
  exact.exact_vertices = options.exact_vertices || options.rounding || options.measure;
  BooleanResult result = evaluate(exact);
  const std::size_t vertices = result.mesh.vertices.size(), triangles = result.mesh.triangles.size();
  if (options.measure) {
    arena_for(options, triangles).execute([&] {
      const Monitor monitor(options.cancel);
      result.measured = {vertices, triangles, measures_of({result.mesh, result.exact}, Facets::count, monitor)};
    });
  }
  if (options.exact_vertices) return result;
  if (options.rounding) {
    const ExactMesh mesh{std::move(result.mesh), std::move(result.exact)};
    put_rounded(round_to_solid(mesh, *options.rounding, options), result);
  }
  result.exact.clear();
  return result;
}

bool carries_attributes(std::span<const Operand> operands, const Options& options) {
  return options.cut_material != nullptr || have_attributes(operands);
}

/// Attributes of an exact result.
void put_attributes(std::span<const Operand> operands, const Options& options, CutFaces cut_faces,
                    BooleanResult& result) {
  std::vector<AttributedMesh> sources;
  for (const Operand& o : operands) sources.push_back({{o.mesh, o.exact}, o.attributes});
  Stopwatch watch(result.profile);
  arena_for(options, result.mesh.triangles.size()).execute([&] {
    const CarryRules rules{options.cut_material, cut_faces};
    result.attributes = carry(sources, {result.mesh, result.exact}, result.sources, rules, Monitor(options.cancel));
  });
  watch.lap("attributes");
}

/// Rounds an exact result with attributes.
void round_with_attributes(const CoordinateGrid& grid, const Options& options, BooleanResult& result) {
  const ExactMesh exact{std::move(result.mesh), std::move(result.exact)};
  RoundedMesh rounded = round_to_solid(exact, grid, options);
  result.attributes = carry_attributes({exact, &result.attributes}, rounded, grid, options);
  put_rounded(std::move(rounded), result);
}

/// Evaluates, and carries attributes if there are any: from the exact result, which is rounded after that.
template <class Evaluate>
BooleanResult with_attributes(std::span<const Operand> operands, const Options& options, CutFaces cut_faces,
                              const Evaluate& evaluate) {
  if (!carries_attributes(operands, options)) return evaluate(options);
  if (options.engine != nullptr && !options.engine->keeps_faces)
    throw std::invalid_argument(std::string("the engine ") + options.engine->name + " carries no attributes");
  for (const Operand& o : operands)
    if (o.attributes != nullptr) check_attributes(*o.attributes, o.mesh.vertices.size(), o.mesh.triangles.size());
  Options exact = options;
  exact.exact_vertices = true;
  exact.rounding.reset();
  BooleanResult result = evaluate(exact);
  put_attributes(operands, options, cut_faces, result);
  if (options.exact_vertices) return result;
  if (options.rounding) round_with_attributes(*options.rounding, options, result);
  result.exact.clear();
  return result;
}

CutFaces cut_faces_of(Operation operation) {
  return operation == Operation::intersection ? CutFaces::of_later_operands : CutFaces::turned;
}

}  // namespace

BooleanResult combine(Operation operation, std::span<const Operand> operands, const Options& options) {
  return with_attributes(operands, options, cut_faces_of(operation), [&](const Options& wanted) {
    return with_found_class(operands, wanted, [&](const Options& found, KnownOperands known) {
      if (found.engine != nullptr)
        return by_engine(found, [&](const Options& o) { return o.engine->combine(operation, operands, o); });
      const Rule rule(operation, static_cast<std::uint32_t>(operands.size()));
      return combine(with_keepers(rule, operands, found, false), operands, found, std::move(known));
    });
  });
}

BooleanResult combine(const Formula& formula, std::span<const Operand> operands, const Options& options) {
  if (formula.operands() != operands.size())
    throw std::invalid_argument("the formula is about " + std::to_string(formula.operands()) + " operands, not " +
                                std::to_string(operands.size()));
  if (formula.holds({})) throw std::invalid_argument("the result is not bounded");
  if (options.engine != nullptr && options.engine->evaluate == nullptr)
    throw std::invalid_argument(std::string("the engine ") + options.engine->name + " evaluates no formulas");
  return with_attributes(operands, options, CutFaces::turned, [&](const Options& wanted) {
    return with_found_class(operands, wanted, [&](const Options& found, KnownOperands known) {
      if (found.engine != nullptr)
        return by_engine(found, [&](const Options& o) { return o.engine->evaluate(formula, operands, o); });
      return combine(with_keepers(Rule(formula), operands, found, true), operands, found, std::move(known));
    });
  });
}

BooleanResult combine(Operation operation, std::span<const MeshView> operands, const Options& options) {
  std::vector<Operand> all;
  for (const MeshView& m : operands) all.push_back({m, {}, false});
  return combine(operation, std::span<const Operand>(all), options);
}

}  // namespace strata
