#include "core/csg/round_to_solid.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/containers/collect.h"
#include "core/containers/huge_pages.h"
#include "core/csg/arena.h"
#include "core/csg/inspection.h"
#include "core/csg/moved_vertices.h"
#include "core/csg/resolve_again.h"
#include "core/exact/finite.h"
#include "core/exact/number_text.h"
#include "core/kernel/disjoint_sets.h"
#include "core/kernel/grid_rounding.h"
#include "core/mesh/connections.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/lattice_sum.h"
#include "core/round/distances.h"
#include "core/round/flatten.h"
#include "core/round/moving_mesh.h"
#include "core/round/repair.h"
#include "core/round/surface_distance.h"
#include "core/round/wrong_faces.h"
#include "strata/rounding.h"

namespace strata {
namespace {

/// So often faces are resolved with vertices on the nearest numbers of the grid. Then each time leaves out more bits.
constexpr int full_resolves = 40;
constexpr int bits_per_resolve = 2;
/// Wrong faces are repaired so often before they are resolved.
constexpr int most_repairs = 3;
/// What moved by more units than this is far.
constexpr double far_units = 4;

int bits_less_in(int resolves) {
  return resolves < full_resolves ? 0 : bits_per_resolve * (resolves - full_resolves + 1);
}

/// How far repairs may move something, in units of the grid: one, as long as resolving brings the wrong faces to half
/// of the fewest before within some times; then twice as far. It grows at once where there are far more of them. A far
/// reach takes thick features away, so it waits where the number goes up and down: sheets that lie on each other need
/// several times. Piles are flattened within two units of a plane, or four where there are not half as many. As a last
/// resort, boundaries of whole piles are divided: where there are not half as many twice in a row, or twice as many as
/// the fewest.
class Reach {
 public:
  [[nodiscard]] double now() const { return reach_; }
  [[nodiscard]] double of_piles() const { return (are_piles_thick_ ? 4 : 2) * reach_; }
  [[nodiscard]] bool may_divide_piles() const { return is_growing_ || resolves_ >= 2; }

  /// After repairs that left this many wrong faces: resolve, or repair again with the new reach?
  bool is_time_to_resolve(std::size_t wrong_faces) {
    constexpr int patience = 12, most_growths = 2;
    constexpr std::size_t far_more = 3, few = 32;
    is_growing_ = wrong_faces / 2 > fewest_;
    const bool is_better = wrong_faces <= fewest_ / 2;
    if (!is_better && !std::exchange(are_piles_thick_, true)) return false;
    if (wrong_faces / far_more > std::max(fewest_, few) && growths_ < most_growths) {
      grow();
      ++growths_;
      return false;
    }
    growths_ = 0;
    if (is_better) {
      fewest_ = wrong_faces;
      resolves_ = 0;
      are_piles_thick_ = false;
    } else if (++resolves_ == patience) {
      grow();
      resolves_ = 0;
    }
    return true;
  }

 private:
  void grow() {
    constexpr double growth = 2, largest = 0x1p1000;
    reach_ = std::min(growth * reach_, largest);
  }

  double reach_ = 1;
  bool are_piles_thick_ = false, is_growing_ = false;
  int resolves_ = 0, growths_ = 0;
  std::size_t fewest_ = std::numeric_limits<std::size_t>::max();
};

void set_searched(MovingMesh& mesh, const ChangedRegion& region, const std::vector<std::uint32_t>& wrong) {
  if (mesh.swept()) return;
  if (region.is_all()) {
    mesh.set_searched(wrong, region.stars_of_mesh());
  } else {
    mesh.set_searched(wrong);
  }
}

bool does_not_end_soon(std::uint64_t rounds, std::size_t first_wrong_faces, std::size_t wrong_faces) {
  constexpr std::uint64_t many_rounds = 40;
  constexpr std::size_t far_more = 4, few = 256;
  return rounds > many_rounds || wrong_faces / far_more > std::max(first_wrong_faces, few);
}

/// A mesh whose faces near changes are not wrong: are its winding numbers 0 and 1?
bool winds_like_a_solid(const MovingMesh& mesh, const ChangedRegion& region, const Monitor& monitor) {
  if (region.keeps_windings()) return true;
  if (region.is_all())
    return region.part().triangles.empty() ||
           windings_are_those_of_a_solid(region.part(), region.stars() ? &*region.stars() : nullptr, monitor);
  std::vector<Triangle> triangles = on_first_vertices(ExactMeshView(mesh.mesh(), {}));
  std::erase_if(triangles, repeats_vertex);
  return triangles.empty() || windings_are_those_of_a_solid({mesh.mesh().vertices, triangles}, nullptr, monitor);
}

class SolidRounding {
 public:
  /// With `compares_topology`, that of the exact mesh is found, unless it is known.
  SolidRounding(const NearestMesh& exact, const GridRounding& grid, bool compares_topology,
                const std::optional<Topology>& known, const Monitor& monitor)
      : exact_(exact), grid_(grid), compares_topology_(compares_topology), known_topology_(known), monitor_(monitor) {}

  struct Outcome {
    std::optional<MovingMesh::Parts> parts;  ///< none: those of the exact mesh, as they are
    RoundingReport report;
  };

  /// Once more from the beginning, with bundles of needles put in order, where it does not end soon without.
  Outcome run() {
    if (std::optional<Outcome> soon = attempt(Bundles::as_they_are)) return std::move(*soon);
    return std::move(*attempt(Bundles::put_in_order));
  }

 private:
  /// None where bundles are left as they are and it does not end soon.
  std::optional<Outcome> attempt(Bundles bundles) {
    reach_ = Reach();
    MovingMesh moving = nearest();
    RoundingReport report;
    int repairs = 0, resolves = 0;
    std::size_t first_wrong = 0;
    for (;;) {
      monitor_.check();
      ChangedRegion region(moving, monitor_);
      const std::vector<std::uint32_t> wrong = region.wrong_faces(monitor_);
      if (region.is_complete()) set_searched(moving, region, wrong);
      if (wrong.empty() && winds_like_a_solid(moving, region, monitor_)) {
        const std::vector<VertexMove> met =
            vertices_that_met(moving, region, report.rounds == 0 && !region.has_collapsed());
        moving.move(met);
        report.rounds += given_up_rounds_;
        return finished(std::move(moving), &region, report, !met.empty());
      }
      if (++report.rounds == 1) first_wrong = wrong.size();
      if (bundles == Bundles::as_they_are && does_not_end_soon(report.rounds, first_wrong, wrong.size())) {
        given_up_rounds_ = report.rounds;
        return {};
      }
      if (!wrong.empty() && repairs < most_repairs && repaired(moving, region, wrong, bundles, repairs > 0)) {
        ++repairs;
        continue;
      }
      repairs = 0;
      if (!wrong.empty() && !reach_.is_time_to_resolve(wrong.size())) continue;
      if (!resolve_again(moving, region, wrong, grid_, bits_less_in(++resolves), monitor_)) {
        report.rounds += given_up_rounds_;
        return finished(std::move(moving), nullptr, report, false);
      }
    }
  }

  [[nodiscard]] MovingMesh nearest() const {
    const std::span<const Vertex> points = exact_.mesh.vertices;
    const bool holds_all = grid_.holds_all_doubles();
    std::vector<bool> is_rounded(holds_all ? 0 : points.size(), false);
    if (!holds_all)
      for (const std::uint32_t v : exact_.rounded) is_rounded[v] = true;
    const std::vector<std::uint32_t> moving = holds_all ? exact_.rounded : collect(points.size(), [&](std::uint32_t v) {
      return is_rounded[v] || grid_(points[v], 0) != points[v];
    });
    std::vector<VertexMove> moves;
    resize_fresh(moves, moving.size());
    std::atomic<bool> are_finite = true;
    tbb::parallel_for(std::size_t{0}, moving.size(), [&](std::size_t n) {
      const std::uint32_t v = moving[n];
      moves[n] = move_to_grid(v, points[v], holds_all || is_rounded[v], grid_);
      if (!is_finite(moves[n].to)) are_finite.store(false, std::memory_order_relaxed);
    });
    if (!are_finite)
      refuse(std::find_if(moves.begin(), moves.end(), [](const VertexMove& m) { return !is_finite(m.to); })->vertex);
    MovingMesh result(exact_.mesh);
    result.move(moves);
    return result;
  }

  /// Piles of sheets are flattened where other repairs did not suffice.
  [[nodiscard]] bool repaired(MovingMesh& moving, const ChangedRegion& region, const std::vector<std::uint32_t>& wrong,
                              Bundles bundles, bool is_second_time) const {
    const bool is_changed = repair(moving, region, wrong, grid_, reach_.now(), bundles);
    if (is_changed && !is_second_time) return true;
    return flatten(moving, region, wrong, grid_, reach_.of_piles(), reach_.may_divide_piles()) || is_changed;
  }

  /// Vertices that became equal are one; copies of one vertex in the exact mesh stay copies.
  [[nodiscard]] std::vector<VertexMove> vertices_that_met(const MovingMesh& moving, const ChangedRegion& region,
                                                          bool are_those_of_the_exact_mesh) const {
    std::vector<VertexMove> met;
    for (const auto& [vertex, first] : region.equal_vertices())
      if (!are_those_of_the_exact_mesh || !is_one_position(vertex, first))
        met.push_back({vertex, first, moving.mesh().vertices[vertex], 0});
    return met;
  }

  /// Of two vertices of the exact mesh.
  [[nodiscard]] bool is_one_position(std::uint32_t a, std::uint32_t b) const {
    const auto is_rounded = [&](std::uint32_t v) {
      return std::binary_search(exact_.rounded.begin(), exact_.rounded.end(), v);
    };
    if (is_rounded(a) != is_rounded(b) || exact_.mesh.vertices[a] != exact_.mesh.vertices[b]) return false;
    return !is_rounded(a) || exact_.are_equal(a, b);
  }

  [[noreturn]] void refuse(std::size_t v) const {
    const Vertex& at = exact_.mesh.vertices[v];
    throw std::invalid_argument("vertex " + std::to_string(v) + " at (" + number_text(at[0]) + ", " +
                                number_text(at[1]) + ", " + number_text(at[2]) +
                                ") is beyond the largest number of the format");
  }

  /// `region`: what was searched last, if it was.
  Outcome finished(MovingMesh moving, const ChangedRegion* region, RoundingReport report,
                   bool have_vertices_met) const {
    report.unit = grid_.unit_at(largest_coordinate(exact_.mesh.vertices));
    if (moving.is_as_given()) {
      if (region != nullptr) count_moved_vertices(moving, *region, far_units * report.unit, report);
      for (const double moved : moving.moved_of_changed())
        report.largest_movement = std::max(report.largest_movement, moved);
      return {std::nullopt, report};
    }
    MovingMesh::Parts parts = std::move(moving).take();
    report.is_rearranged = report.rounds > 0 || have_vertices_met;
    tbb::parallel_invoke(  // other members of the report each
        [&] {
          if (report.is_rearranged) compare(parts, report);
        },
        [&] {
          tighten_distances(exact_, parts.mesh, far_units * report.unit, monitor_, parts.moved);
          count_moved_vertices(parts, far_units * report.unit, report);
          for (const double moved : parts.moved) report.largest_movement = std::max(report.largest_movement, moved);
        });
    return {std::move(parts), report};
  }

  void compare(const MovingMesh::Parts& rounded, RoundingReport& report) const {
    std::vector<char> is_left;
    resize_fresh(is_left, exact_.mesh.triangles.size());
    for (const std::uint32_t f : rounded.source_face) is_left[f] = 1;
    const std::vector<std::uint32_t> vanished =
        collect(is_left.size(), [&](std::uint32_t f) { return is_left[f] == 0; });
    report.vanished_faces = vanished.size();
    report.vanished_components = components_of(vanished, is_left);
    if (!compares_topology_) return;
    tbb::parallel_invoke([&] { report.exact = known_topology_ ? *known_topology_ : topology_of(exact_); },
                         [&] {
                           report.rounded = topology_of({rounded.mesh, {}, {}});
                         });
  }

  /// Of exact faces: sets that are connected over vertices which no other face has.
  [[nodiscard]] std::uint64_t components_of(const std::vector<std::uint32_t>& faces,
                                            const std::vector<char>& is_other) const {
    if (faces.empty()) return 0;
    const std::span<const Triangle> triangles = exact_.mesh.triangles;
    std::vector<char> is_of_others;  // per vertex
    resize_fresh(is_of_others, exact_.mesh.vertices.size());
    tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t f) {
      if (is_other[f] != 0)
        for (const std::uint32_t v : triangles[f])
          if (const std::atomic_ref at(is_of_others[v]); at.load(std::memory_order_relaxed) == 0)
            at.store(1, std::memory_order_relaxed);
    });
    DisjointSets<std::uint32_t> connected(is_of_others.size());
    for (const std::uint32_t f : faces)
      for (const std::uint32_t v : triangles[f]) connected.unite(triangles[f][0], v);
    for (const std::uint32_t f : faces)
      for (const std::uint32_t v : triangles[f])
        if (is_of_others[v] != 0) is_of_others[connected.find(v)] = 1;
    std::uint64_t count = 0;
    for (const std::uint32_t f : faces) count += std::exchange(is_of_others[connected.find(triangles[f][0])], 1) == 0;
    return count;
  }

  const NearestMesh& exact_;
  const GridRounding& grid_;
  bool compares_topology_;
  std::optional<Topology> known_topology_;
  const Monitor& monitor_;
  Reach reach_;
  std::uint64_t given_up_rounds_ = 0;
};

}  // namespace

void round_result(const NearestMesh& mesh, const Options& options, const Monitor& monitor, BooleanResult& result) {
  const GridRounding rounding(*options.rounding);
  std::optional<Topology> known;
  if (result.measured) known = result.measured->measures.topology;
  auto [parts, report] = SolidRounding(mesh, rounding, options.measure, known, monitor).run();
  if (parts) return put_rounded({std::move(parts->mesh), std::move(parts->source_face), report}, result);
  result.exact.clear();
  result.rounding = report;
}

void put_rounded(RoundedMesh rounded, BooleanResult& result) {
  std::vector<Source> sources;
  resize_fresh(sources, rounded.source_face.size());
  tbb::parallel_for(std::size_t{0}, sources.size(),
                    [&](std::size_t i) { sources[i] = result.sources[rounded.source_face[i]]; });
  result.mesh = std::move(rounded.mesh);
  result.sources = std::move(sources);
  result.exact.clear();
  result.rounding = rounded.report;
}

RoundedMesh round_to_solid(const ExactMesh& mesh, const CoordinateGrid& grid, const Options& options) {
  const Monitor monitor(options.cancel);
  return arena_for(options, mesh.mesh.triangles.size()).execute([&]() -> RoundedMesh {
    const GridRounding rounding(grid);
    auto [parts, report] = SolidRounding(NearestMesh::of(mesh), rounding, options.measure, {}, monitor).run();
    if (!parts) parts = MovingMesh(mesh.mesh).take();
    return {std::move(parts->mesh), std::move(parts->source_face), report};
  });
}

}  // namespace strata
