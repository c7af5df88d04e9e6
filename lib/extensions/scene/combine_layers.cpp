#include <array>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/cells/cell_tree.h"
#include "core/csg/arena.h"
#include "core/csg/broken_operands.h"
#include "core/csg/resolved_operand.h"
#include "core/csg/stopwatch.h"
#include "core/kernel/input_complex.h"
#include "core/mesh/prepare.h"
#include "core/overlap/coincidences.h"
#include "core/overlap/pairs.h"
#include "core/round/rounding.h"
#include "core/select/merge.h"
#include "core/select/split_faces.h"
#include "core/select/whole_faces.h"
#include "extensions/scene/common_origin.h"
#include "extensions/scene/layer_decomposition_data.h"
#include "strata/query.h"

namespace strata {
namespace {

/// The boundary of what a rule keeps of solids that do not cross themselves, one covering each about one origin.
Boundary evaluate_about_origin(InputComplex& input, std::span<const SignedCovering* const> coverings, const Rule& rule,
                               PointTable& points, const Monitor& monitor) {
  const CommonOrigin oracle(input, coverings);
  const CellTree cells(input, {.self = false, .monitor = monitor});  // finds pairs; its origins are not used
  input.identify(find_coincidences(input, cells, monitor));
  const Intersections intersections = find_intersections(input, cells, false, points, monitor);
  Pools pools;
  std::vector<SplitFace> split = split_faces(input, oracle, rule, intersections, false, points, pools, monitor);
  const auto whole = judge_whole_faces(input, oracle, nullptr, rule, split, false, monitor);
  merge_pieces(input, points, split, pools, monitor);
  return gather_boundary(input, whole, split, points);
}

void add_solid(InputComplex& input, const ExactMesh& solid) {
  input.add(solid.mesh.vertices, solid.mesh.triangles, solid.exact);
}

ExactMesh combine_boundaries(const LayerDecomposition& a, const LayerDecomposition& b, Operation operation,
                             const Monitor& monitor) {
  InputComplex input;
  for (const LayerDecomposition* d : {&a, &b}) add_solid(input, d->scene().solid(0));
  const std::array<const SignedCovering*, 2> coverings{&covering_of(a), &covering_of(b)};
  PointTable points(input);
  Boundary boundary = evaluate_about_origin(input, coverings, Rule(operation, 2), points, monitor);
  ExactMesh result;
  result.mesh.vertices = round_to_doubles(input, points, boundary, monitor);
  result.exact = exact_positions(input, points, boundary, result.mesh.vertices, monitor);
  result.mesh.triangles = std::move(boundary.triangles);
  return result;
}

/// Solids made of operands, the faces they come from, and their coverings about one origin.
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
  [[nodiscard]] const std::vector<ExactMesh>& solids() const { return solids_; }
  [[nodiscard]] std::vector<const SignedCovering*> coverings() const {
    std::vector<const SignedCovering*> all;
    for (const auto& covering : coverings_) all.push_back(covering.get());
    return all;
  }
  /// From faces of the solids to those of the caller.
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
  InputComplex input;
  for (const ExactMesh& solid : operands.solids()) add_solid(input, solid);
  PointTable points(input);
  Boundary boundary = evaluate_about_origin(input, operands.coverings(), rule, points, monitor);
  watch.lap("arrange");
  monitor.report(0.9);
  result.mesh.vertices = round_to_doubles(input, points, boundary, monitor);
  if (options.exact_vertices) result.exact = exact_positions(input, points, boundary, result.mesh.vertices, monitor);
  result.mesh.triangles = std::move(boundary.triangles);
  result.sources = std::move(boundary.sources);
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
  tbb::task_arena arena = arena_for(options, operands.face_count());
  arena.execute([&] { evaluate_in_layers(rule, operands, options, monitor, result); });
  if (!chain_is_closed(result.mesh)) {
    refuse_broken_operands(given, options);
    throw LogicError("the boundary of a result is not closed");
  }
  monitor.report(1);
  return result;
}

BooleanResult combine_in_layers(Operation operation, std::span<const Operand> operands, const Options& options) {
  return evaluate_in_layers(Rule(operation, static_cast<std::uint32_t>(operands.size())), operands, options);
}

BooleanResult evaluate_formula_in_layers(const Formula& formula, std::span<const Operand> operands,
                                         const Options& options) {
  return evaluate_in_layers(Rule(formula), operands, options);
}

}  // namespace

LayerDecomposition combine(const LayerDecomposition& a, const LayerDecomposition& b, Operation operation,
                           const Options& options) {
  if (!(a.origin() == b.origin())) throw std::invalid_argument("the decompositions have different origins");
  if (a.scene().solid_count() != 1 || b.scene().solid_count() != 1)
    throw std::invalid_argument("a decomposition to be combined is not of one solid");
  const Monitor monitor(options.cancel, &options.progress);
  tbb::task_arena arena = arena_for(options, a.scene().face_count() + b.scene().face_count());
  std::optional<LayerDecomposition> result;
  arena.execute([&] {
    std::vector<ExactMesh> solids;
    solids.push_back(combine_boundaries(a, b, operation, monitor));
    result.emplace(Scene(std::move(solids)), a.origin(), monitor);
  });
  return *std::move(result);
}

const Engine layer_engine{"layers", combine_in_layers, evaluate_formula_in_layers};

}  // namespace strata
