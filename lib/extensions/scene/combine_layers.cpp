#include <array>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/csg/arena.h"
#include "core/csg/broken_operands.h"
#include "core/csg/resolved_operand.h"
#include "core/csg/stopwatch.h"
#include "core/kernel/input_complex.h"
#include "core/mesh/prepare.h"
#include "core/overlap/candidates.h"
#include "core/overlap/intersect.h"
#include "core/round/rounding.h"
#include "core/select/extract.h"
#include "core/select/label.h"
#include "core/select/subdivide.h"
#include "extensions/scene/common_origin.h"
#include "extensions/scene/layer_decomposition_data.h"
#include "strata/query.h"

namespace strata {
namespace {

/// A Boolean of solids that do not intersect themselves, with one covering each about one origin. The stages are those
/// of `boolean`; winding numbers come from the coverings, and cells only find the pairs of faces that may meet.
class BooleanAboutOrigin {
 public:
  BooleanAboutOrigin(std::span<const ExactMesh* const> solids, std::span<const SignedCovering* const> coverings,
                     const Rule& rule, const Monitor& monitor)
      : candidates_(find_candidates(complex_of(solids), monitor)),
        boundary_(boundary_of(candidates_, coverings, rule, monitor)) {}

  [[nodiscard]] const InputComplex& input() const { return candidates_.input(); }
  [[nodiscard]] Boundary& boundary() { return boundary_; }

 private:
  static InputComplex complex_of(std::span<const ExactMesh* const> solids) {
    InputComplex complex;
    for (const ExactMesh* s : solids) complex.add(s->mesh.vertices, s->mesh.triangles, s->exact);
    return complex;
  }
  static Boundary boundary_of(const Candidates& candidates, std::span<const SignedCovering* const> coverings,
                              const Rule& rule, const Monitor& monitor) {
    const InputComplex& input = candidates.input();
    const CommonOrigin oracle(input, coverings);
    const Classifier classifier{rule, oracle};
    Subdivision subdivision = subdivide(input, intersect(candidates, monitor), classifier, monitor);
    const std::vector<Verdict> verdicts = label(input, subdivision, classifier, monitor);
    return extract(input, verdicts, std::move(subdivision), monitor);
  }

  Candidates candidates_;
  Boundary boundary_;
};

ExactMesh combine_boundaries(const LayerDecomposition& a, const LayerDecomposition& b, Operation operation,
                             const Monitor& monitor) {
  const std::array<const ExactMesh*, 2> solids{&a.scene().solid(0), &b.scene().solid(0)};
  const std::array<const SignedCovering*, 2> coverings{&covering_of(a), &covering_of(b)};
  BooleanAboutOrigin made(solids, coverings, Rule(operation, 2), monitor);
  ExactMesh result;
  result.mesh.vertices = round_to_doubles(made.input(), made.boundary(), monitor);
  result.exact = exact_positions(made.input(), made.boundary(), result.mesh.vertices, monitor);
  result.mesh.triangles = std::move(made.boundary().triangles);
  return result;
}

/// Solids that represent operands, the faces from which they come, and their coverings about one origin.
class CoveredOperands {
 public:
  CoveredOperands(std::span<const Operand> operands, const Options& options, std::vector<Defect>& notes) {
    for (std::uint32_t i = 0; i < operands.size(); ++i) {
      BooleanResult one = resolved_operand(operands[i], options, i);
      notes.insert(notes.end(), one.notes.begin(), one.notes.end());
      solids_.push_back({std::move(one.mesh), std::move(one.exact)});
      sources_.push_back(std::move(one.sources));
    }
  }

  void cover(const Monitor& monitor) {
    const Origin origin = choose_origin(Scene(solids_));
    for (const ExactMesh& solid : solids_) {
      monitor.check();
      coverings_.push_back(std::make_unique<SignedCovering>(Scene({solid}), origin));
    }
  }

  [[nodiscard]] std::size_t face_count() const {
    std::size_t count = 0;
    for (const ExactMesh& solid : solids_) count += solid.mesh.triangles.size();
    return count;
  }
  [[nodiscard]] std::vector<const ExactMesh*> solids() const {
    std::vector<const ExactMesh*> all;
    for (const ExactMesh& solid : solids_) all.push_back(&solid);
    return all;
  }
  [[nodiscard]] std::vector<const SignedCovering*> coverings() const {
    std::vector<const SignedCovering*> all;
    for (const auto& covering : coverings_) all.push_back(covering.get());
    return all;
  }
  /// Maps faces of the solids to those of the caller.
  void restore(std::vector<Source>& sources) const {
    for (Source& s : sources) s.face = sources_[s.operand][s.face].face;
  }

 private:
  std::vector<ExactMesh> solids_;
  std::vector<std::vector<Source>> sources_;
  std::vector<std::unique_ptr<SignedCovering>> coverings_;
};

void evaluate_in_layers(const Rule& rule, CoveredOperands& operands, const Options& options, const Monitor& monitor,
                        BooleanResult& result) {
  Stopwatch watch(result.profile);
  operands.cover(monitor);
  watch.lap("cover");
  monitor.report(0.5);
  BooleanAboutOrigin made(operands.solids(), operands.coverings(), rule, monitor);
  watch.lap("arrange");
  monitor.report(0.9);
  result.mesh.vertices = round_to_doubles(made.input(), made.boundary(), monitor);
  if (options.exact_vertices)
    result.exact = exact_positions(made.input(), made.boundary(), result.mesh.vertices, monitor);
  result.mesh.triangles = std::move(made.boundary().triangles);
  result.sources = std::move(made.boundary().sources);
  operands.restore(result.sources);
  watch.lap("round");
}

BooleanResult evaluate_in_layers(const Rule& rule, std::span<const Operand> given, const Options& options) {
  BooleanResult result;
  const Monitor monitor(options.cancel, &options.progress);
  Stopwatch watch(result.profile);
  CoveredOperands operands(given, options, result.notes);
  watch.lap("prepare");
  monitor.report(0.2);
  const Arena arena = arena_for(options, operands.face_count());
  refusing_broken_operands(given, options, [&] {
    arena.execute([&] { evaluate_in_layers(rule, operands, options, monitor, result); });
    if (!chain_is_closed(result.mesh)) throw LogicError("the boundary of a result is not closed");
  });
  monitor.report(1);
  return result;
}

BooleanResult combine_in_layers(Operation operation, std::span<const Operand> operands, const Options& options) {
  return evaluate_in_layers(Rule(operation, static_cast<std::uint32_t>(operands.size())), operands, options);
}

BooleanResult evaluate_formula_in_layers(const Formula& formula, std::span<const Operand> operands,
                                         const Options& options) {
  return evaluate_in_layers(Rule(formula).by_first_keeper(), operands, options);
}

}  // namespace

LayerDecomposition combine(const LayerDecomposition& a, const LayerDecomposition& b, Operation operation,
                           const Options& options) {
  if (!(a.origin() == b.origin())) throw std::invalid_argument("the decompositions have different origins");
  if (a.scene().solid_count() != 1 || b.scene().solid_count() != 1)
    throw std::invalid_argument("a decomposition to be combined is not of one solid");
  const Monitor monitor(options.cancel, &options.progress);
  const Arena arena = arena_for(options, a.scene().face_count() + b.scene().face_count());
  std::optional<LayerDecomposition> result;
  arena.execute([&] {
    std::vector<ExactMesh> solids;
    solids.push_back(combine_boundaries(a, b, operation, monitor));
    result.emplace(Scene(std::move(solids)), a.origin(), monitor);
  });
  return *std::move(result);
}

const Engine layer_engine{"layers", combine_in_layers, evaluate_formula_in_layers, true};

}  // namespace strata
