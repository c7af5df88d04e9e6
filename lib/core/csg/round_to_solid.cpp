#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/csg/arena.h"
#include "core/csg/boolean.h"
#include "core/csg/clusters.h"
#include "core/csg/inspection.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/prepare.h"
#include "core/overlap/self_intersections.h"
#include "core/round/grid_rounding.h"
#include "strata/rounding.h"

namespace strata {
namespace {

/// Rounds in which vertices take the nearest numbers of the grid. Then each round leaves out more bits.
constexpr std::uint64_t full_rounds = 60;
constexpr int bits_per_round = 2;
/// After so many rounds, near vertices of faces that cross are joined.
constexpr std::uint64_t plain_rounds = 2;

int bits_less_in(std::uint64_t round) {
  return round < full_rounds ? 0 : bits_per_round * static_cast<int>(round - full_rounds + 1);
}

/// The distance of vertices that are joined, in units. It grows where faces still cross after some rounds, and soon
/// where there are more and more of them.
class Reach {
 public:
  double after(std::uint64_t round, std::size_t pairs) {
    constexpr std::uint64_t few_rounds = 8;
    constexpr std::size_t many = 4;
    fewest_pairs_ = std::min(fewest_pairs_, pairs);
    if (round < few_rounds) return reach_;
    if (pairs / many > fewest_pairs_) {
      reach_ *= 4;
    } else if (round % 2 == 0) {
      reach_ *= 2;
    }
    return reach_;
  }

 private:
  double reach_ = 1;
  std::size_t fewest_pairs_ = std::numeric_limits<std::size_t>::max();
};

double distance(const Vertex& a, const Vertex& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// At least the rounding error of a coordinate rounded to the nearest double.
double half_unit(const Vertex& v) {
  const double size = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  const double next = std::nextafter(size, std::numeric_limits<double>::infinity());
  const double unit = std::isfinite(next) ? next - size : size - std::nextafter(size, 0.0);
  return std::max(unit / 2, std::numeric_limits<double>::denorm_min());
}

bool is_finite(const Vertex& v) {
  return std::all_of(v.begin(), v.end(), [](double x) { return std::isfinite(x); });
}

/// A mesh on its way to the grid.
struct Moving {
  Mesh mesh;
  std::vector<std::uint32_t> source_face;  ///< per triangle, of the exact boundary
  std::vector<double> moved;               ///< per triangle: no point of it is farther from the exact boundary
};

/// What the triangles of a closed chain bound.
enum class Bounds {
  solid,
  touching_solid,  ///< a solid, if vertices with equal coordinates are one
  no_solid
};

Bounds bounds_of(const Mesh& mesh, const Monitor& monitor) {
  if (mesh.triangles.empty() || is_plainly_solid(mesh, monitor)) return Bounds::solid;
  const std::vector<Triangle> triangles = on_first_vertices(ExactMeshView(mesh, {}));
  if (std::any_of(triangles.begin(), triangles.end(), repeats_vertex)) return Bounds::no_solid;
  const MeshView identified(mesh.vertices, triangles);
  const Screening facts = screen(identified);
  const bool is_solid = facts.orientation > 0 && !facts.degenerate &&
                        Inspection(ExactMeshView(identified, {}), monitor, 1).finds_nothing();
  return is_solid ? Bounds::touching_solid : Bounds::no_solid;
}

/// Without triangles that repeat a vertex, and with faces of positive area only.
Prepared without_degenerate_faces(const Mesh& mesh) {
  Mesh distinct{mesh.vertices, on_first_vertices(ExactMeshView(mesh, {}))};
  std::vector<std::uint32_t> kept;
  for (std::uint32_t f = 0; f < distinct.triangles.size(); ++f) {
    if (repeats_vertex(distinct.triangles[f])) continue;
    distinct.triangles[kept.size()] = distinct.triangles[f];
    kept.push_back(f);
  }
  distinct.triangles.resize(kept.size());
  Prepared prepared = prepare_closed(distinct, true);
  for (std::uint32_t& f : prepared.source_face) f = kept[f];
  if (prepared.source_face.empty()) prepared.source_face = std::move(kept);
  if (!prepared.mesh) prepared.mesh = std::move(distinct);
  return prepared;
}

class SolidRounding {
 public:
  SolidRounding(const ExactMesh& exact, const GridRounding& grid, const Monitor& monitor)
      : exact_(exact), grid_(grid), monitor_(monitor) {}

  RoundedMesh run() {
    Moving moving = nearest();
    RoundingReport report;
    Bounds bounds = Bounds::no_solid;
    while ((bounds = bounds_of(moving.mesh, monitor_)) == Bounds::no_solid) {
      monitor_.check();
      ++report.rounds;
      std::vector<bool> is_new;
      moving = resolved_again(std::move(moving), report.rounds, is_new);
      if (std::none_of(is_new.begin(), is_new.end(), [](bool x) { return x; })) break;  // a solid on the grid
      round_new_vertices(moving, is_new, bits_less_in(report.rounds));
    }
    if (report.rounds > 0 || bounds == Bounds::touching_solid) compare(moving, report);
    return finished(std::move(moving), report);
  }

 private:
  [[nodiscard]] Moving nearest() const {
    Moving moving{exact_.mesh, {}, std::vector<double>(exact_.mesh.triangles.size(), 0)};
    std::vector<double> way(exact_.mesh.vertices.size(), 0);
    for (const ExactVertex& e : exact_.exact) way[e.vertex] = half_unit(exact_.mesh.vertices[e.vertex]);
    for (std::size_t v = 0; v < way.size(); ++v) {
      way[v] += move(moving.mesh.vertices[v], 0);
      if (!is_finite(moving.mesh.vertices[v])) refuse(v);
    }
    add_ways(way, moving);
    moving.source_face.resize(moving.mesh.triangles.size());
    std::iota(moving.source_face.begin(), moving.source_face.end(), 0U);
    return moving;
  }

  [[noreturn]] void refuse(std::size_t v) const {
    const Vertex& at = exact_.mesh.vertices[v];
    throw std::invalid_argument("vertex " + std::to_string(v) + " at (" + std::to_string(at[0]) + ", " +
                                std::to_string(at[1]) + ", " + std::to_string(at[2]) +
                                ") is beyond the largest number of the format");
  }

  /// Rounds a vertex; returns how far that is.
  [[nodiscard]] double move(Vertex& v, int bits_less) const {
    const Vertex before = std::exchange(v, grid_(v, bits_less));
    return distance(before, v);
  }

  /// A triangle moves by no more than that corner of it which moves most.
  static void add_ways(const std::vector<double>& way, Moving& moving) {
    for (std::size_t t = 0; t < moving.moved.size(); ++t) {
      const Triangle& corners = moving.mesh.triangles[t];
      moving.moved[t] += std::max({way[corners[0]], way[corners[1]], way[corners[2]]});
    }
  }

  /// The next mesh, resolved exactly. Vertices that are not on the grid are new.
  Moving resolved_again(Moving from, std::uint64_t round, std::vector<bool>& is_new) {
    Prepared prepared = without_degenerate_faces(from.mesh);
    if (round > plain_rounds) {
      join(from, prepared, round);
      prepared = without_degenerate_faces(from.mesh);
    }
    if (prepared.mesh->triangles.empty()) return {};
    BooleanResult result = resolved(complex_of(prepared), Inside::winding, monitor_);
    Moving to{std::move(result.mesh), {}, {}};
    for (const Source& s : result.sources) {
      const std::uint32_t source = prepared.source_face[s.face];
      to.source_face.push_back(from.source_face[source]);
      to.moved.push_back(from.moved[source]);
    }
    std::vector<double> way(to.mesh.vertices.size(), 0);
    is_new.resize(to.mesh.vertices.size());
    for (std::size_t v = 0; v < is_new.size(); ++v) is_new[v] = !grid_.holds(to.mesh.vertices[v]);
    for (const ExactVertex& e : result.exact) {
      is_new[e.vertex] = true;
      way[e.vertex] = half_unit(to.mesh.vertices[e.vertex]);
    }
    add_ways(way, to);
    return to;
  }

  static InputComplex complex_of(const Prepared& prepared) {
    InputComplex complex(SelfIntersections::possible);
    complex.add(prepared.mesh->vertices, prepared.mesh->triangles, {}, prepared.bounds);
    return complex;
  }

  /// Replaces the mesh by that without degenerate faces, in which near vertices of faces that cross are one.
  void join(Moving& moving, Prepared& prepared, std::uint64_t round) {
    const auto pairs = find_self_intersections(complex_of(prepared), nullptr, monitor_);
    std::vector<double> moved = join_near_vertices(*prepared.mesh, pairs, grid_, reach_.after(round, pairs.size()));
    std::vector<std::uint32_t> source_face;
    for (std::size_t t = 0; t < moved.size(); ++t) {
      moved[t] += moving.moved[prepared.source_face[t]];
      source_face.push_back(moving.source_face[prepared.source_face[t]]);
    }
    moving = {std::move(*prepared.mesh), std::move(source_face), std::move(moved)};
  }

  /// With fewer bits, the other vertices of triangles with new ones are rounded, too, so that all that is in the way
  /// becomes coarser; without any bits, all vertices are.
  void round_new_vertices(Moving& moving, const std::vector<bool>& is_new, int bits_less) const {
    std::vector<bool> is_rounded = is_new;
    for (const Triangle& t : moving.mesh.triangles)
      if (bits_less > 0 && (is_new[t[0]] || is_new[t[1]] || is_new[t[2]]))
        for (const std::uint32_t v : t) is_rounded[v] = true;
    std::vector<double> way(is_new.size(), 0);
    for (std::size_t v = 0; v < way.size(); ++v)
      if (is_rounded[v] || bits_less >= GridRounding::most_bits) way[v] = move(moving.mesh.vertices[v], bits_less);
    add_ways(way, moving);
  }

  RoundedMesh finished(Moving moving, RoundingReport report) const {
    double largest = 0;
    for (const Vertex& v : exact_.mesh.vertices)
      for (const double x : v) largest = std::max(largest, std::abs(x));
    report.unit = grid_.unit_at(largest);
    count_moved_vertices(moving, report);
    for (const double moved : moving.moved) report.largest_movement = std::max(report.largest_movement, moved);
    return {std::move(moving.mesh), std::move(moving.source_face), report};
  }

  void compare(const Moving& moving, RoundingReport& report) const {
    std::vector<bool> is_left(exact_.mesh.triangles.size(), false);
    for (const std::uint32_t f : moving.source_face) is_left[f] = true;
    report.vanished_faces = static_cast<std::uint64_t>(std::count(is_left.begin(), is_left.end(), false));
    report.exact = topology(exact_);
    report.rounded = topology({moving.mesh, {}});
  }

  /// A vertex is as near to the exact boundary as any of its triangles.
  static void count_moved_vertices(const Moving& moving, RoundingReport& report) {
    std::vector<double> of_vertex(moving.mesh.vertices.size(), std::numeric_limits<double>::infinity());
    for (std::size_t t = 0; t < moving.moved.size(); ++t)
      for (const std::uint32_t v : moving.mesh.triangles[t]) of_vertex[v] = std::min(of_vertex[v], moving.moved[t]);
    for (const double moved : of_vertex) {
      if (std::isinf(moved)) continue;  // no triangle has it
      report.moved_vertices += moved > 0;
      report.far_vertices += moved > 4 * report.unit;
    }
  }

  const ExactMesh& exact_;
  const GridRounding& grid_;
  const Monitor& monitor_;
  Reach reach_;
};

}  // namespace

RoundedMesh round_to_solid(const ExactMesh& mesh, const CoordinateGrid& grid, const Options& options) {
  const GridRounding rounding(grid);
  const Monitor monitor(options.cancel);
  return arena_for(options, mesh.mesh.triangles.size()).execute([&] {
    return SolidRounding(mesh, rounding, monitor).run();
  });
}

}  // namespace strata
