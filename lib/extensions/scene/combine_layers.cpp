#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/cells/cell_tree.h"
#include "core/csg/arena.h"
#include "core/kernel/carriers.h"
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

Boundary evaluate_about_origin(Carriers& carriers, const Surroundings& surroundings, const Rule& rule,
                               PointTable& points, const Monitor& monitor) {
  const CellTree cells(carriers, {.self = false, .monitor = monitor});  // finds pairs; its origins are not used
  carriers.identify(find_coincidences(carriers, cells, monitor));
  const Meetings meetings = find_meetings(carriers, cells, false, points, monitor);
  Pools pools;
  std::vector<SplitFace> split = split_faces(carriers, surroundings, rule, meetings, false, points, pools, monitor);
  const auto whole = judge_whole_faces(carriers, surroundings, nullptr, rule, split, false, monitor);
  merge_pieces(carriers, points, split, pools, monitor);
  return gather_boundary(carriers, whole, split, points);
}

ExactMesh combine_boundaries(const LayerDecomposition& a, const LayerDecomposition& b, Operation operation,
                             const Monitor& monitor) {
  Carriers carriers;
  for (const LayerDecomposition* d : {&a, &b}) {
    const ExactMesh& solid = d->scene().solid(0);
    carriers.add(solid.mesh.vertices, solid.mesh.triangles, solid.exact);
  }
  const std::array<const SignedCovering*, 2> coverings{&covering_of(a), &covering_of(b)};
  const CommonOrigin surroundings(carriers, coverings);
  PointTable points(carriers);
  Boundary boundary = evaluate_about_origin(carriers, surroundings, Rule(operation, 2), points, monitor);
  ExactMesh result;
  result.mesh.vertices = round_to_doubles(carriers, points, boundary, monitor);
  result.exact = exact_places(carriers, points, boundary, result.mesh.vertices, monitor);
  result.mesh.triangles = std::move(boundary.triangles);
  return result;
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

}  // namespace strata
