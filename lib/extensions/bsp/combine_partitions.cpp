#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <optional>
#include <utility>
#include <vector>

#include "core/csg/arena.h"
#include "core/csg/broken_operands.h"
#include "core/csg/resolved_operand.h"
#include "core/csg/stopwatch.h"
#include "core/kernel/hyperplane_table.h"
#include "strata/bsp.h"
#include "strata/combine.h"

namespace strata {
namespace {

/// The first face of an operand in each plane, of either orientation.
class SourcesByPlane {
 public:
  void add(const ExactMesh& mesh, std::span<const Source> sources, std::uint32_t operand) {
    for (std::size_t t = 0; t < sources.size(); ++t) {
      const auto [a, b, c] = mesh.mesh.triangles[t];
      const RationalPoint p = mesh.position(a), q = mesh.position(b), r = mesh.position(c);
      if (!spans(p, q, r)) continue;
      const std::uint32_t plane = planes_.add(plane_through(p, q, r).hyperplane);
      if (plane == sources_.size()) sources_.push_back({operand, sources[t].face});
    }
  }

  /// Nullopt where no operand has a face in a plane.
  [[nodiscard]] std::optional<Source> at(const CanonicalPlane& plane) const {
    const auto& [a, b, c, d] = plane.coefficients;
    const auto number = planes_.find(Hyperplane<3>({a, b, c, -d}));
    return number ? std::optional(sources_[*number]) : std::nullopt;
  }

 private:
  static bool spans(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if ((q[i] - p[i]) * (r[j] - p[j]) != (q[j] - p[j]) * (r[i] - p[i])) return true;
    }
    return false;
  }

  HyperplaneTable<3> planes_;
  std::vector<Source> sources_;  ///< by number of the plane
};

/// Merges by halves: merging operands one after the other would construct a tree as deep as all of them together. A
/// tree that is still deep is rebuilt.
class Merging {
 public:
  explicit Merging(const Monitor& monitor) : monitor_(monitor) {}

  [[nodiscard]] bsp::Partition<3> merged(Operation operation, std::span<const bsp::Partition<3>> regions) const {
    if (regions.empty()) return {};
    if (regions.size() == 1) return regions[0];
    switch (operation) {
      case Operation::difference:
        return pair(operation, regions[0], merged(Operation::union_, regions.subspan(1)));
      case Operation::union_:
      case Operation::intersection:
      case Operation::symmetric_difference:
        return merged_by_halves(operation, regions);
    }
    return {};
  }

 private:
  /// Of an associative operation.
  [[nodiscard]] bsp::Partition<3> merged_by_halves(Operation operation,
                                                   std::span<const bsp::Partition<3>> regions) const {
    const std::size_t half = regions.size() / 2;
    bsp::Partition<3> first, second;
    tbb::parallel_invoke([&] { first = merged(operation, regions.first(half)); },
                         [&] { second = merged(operation, regions.subspan(half)); });
    return pair(operation, first, second);
  }

  [[nodiscard]] bsp::Partition<3> pair(Operation operation, const bsp::Partition<3>& a,
                                       const bsp::Partition<3>& b) const {
    return bsp::rebuilt_if_deep(bsp::combined(operation, a, b, monitor_));
  }

  const Monitor& monitor_;
};

BooleanResult evaluate_in_partitions(Operation operation, std::span<const Operand> operands, const Options& options) {
  BooleanResult result;
  const Monitor monitor(options.cancel, &options.progress);
  Stopwatch watch(result.profile);
  SourcesByPlane sources;
  std::vector<ExactMesh> meshes;
  for (std::uint32_t i = 0; i < operands.size(); ++i) {
    BooleanResult one = resolved_operand(operands[i], options, i);
    result.notes.insert(result.notes.end(), one.notes.begin(), one.notes.end());
    meshes.push_back({std::move(one.mesh), std::move(one.exact)});
    sources.add(meshes.back(), one.sources, i);
  }
  watch.lap("prepare");
  monitor.report(0.2);
  const Arena arena = arena_for(options);
  std::vector<bsp::Partition<3>> regions(meshes.size());
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, meshes.size(), [&](std::size_t i) {
      regions[i] = bsp::partition_of(meshes[i], monitor);
      meshes[i] = {};
    });
  });
  watch.lap("partition");
  monitor.report(0.5);
  const bsp::Partition<3> region = arena.execute([&] { return Merging(monitor).merged(operation, regions); });
  watch.lap("merge");
  monitor.report(0.9);
  const bsp::TreeSize tree = bsp::size_of_tree(region);
  result.profile.counts = {{"nodes", tree.nodes}, {"depth", tree.depth}, {"planes", tree.hyperplanes}};
  bsp::BoundaryMesh boundary = bsp::boundary_mesh(region);
  watch.lap("boundary");
  std::vector<Source> source_of_plane;
  for (const CanonicalPlane& plane : boundary.planes) {
    const std::optional<Source> source = sources.at(plane);
    if (!source)  // the boundary of an operand that crosses itself may be in planes that were only cuts
      throw LogicError("a facet lies in a plane that no operand has");
    source_of_plane.push_back(*source);
  }
  for (const std::uint32_t plane : boundary.plane_of) result.sources.push_back(source_of_plane[plane]);
  result.mesh = std::move(boundary.mesh.mesh);
  if (options.exact_vertices) result.exact = std::move(boundary.mesh.exact);
  monitor.report(1);
  return result;
}

BooleanResult combine_partitions(Operation operation, std::span<const Operand> operands, const Options& options) {
  return refusing_broken_operands(operands, options,
                                  [&] { return evaluate_in_partitions(operation, operands, options); });
}

}  // namespace

const Engine bsp_engine{"bsp", combine_partitions, nullptr};

}  // namespace strata
