#pragma once
/// Exact solids as meshes of doubles or floats that bound solids.
///
/// The vertices of a result are rational. If each is rounded by itself, faces may cross, turn over or lose their area,
/// and the next program refuses the mesh. `round_to_solid` rounds to the nearest numbers where that is a solid, and
/// rearranges faces where it is not.
///
/// All functions are pure; calls from many threads do not disturb each other.
#include <cstdint>
#include <optional>
#include <vector>

#include "strata/coordinate_grid.h"
#include "strata/measure.h"
#include "strata/mesh.h"
#include "strata/options.h"

namespace strata {

/// What rounding did to a solid. Lengths are in model units and in the maximum norm.
struct RoundingReport {
  /// How often faces were repaired or resolved. 0: the vertices, each rounded to the nearest numbers, bound a solid.
  std::uint64_t rounds = 0;
  bool is_rearranged = false;  ///< in rounds, or since vertices met: triangles are not those of the exact boundary
  std::uint64_t moved_vertices = 0;  ///< vertices of the mesh that may be off the exact boundary
  /// The largest distance from a point of the mesh to the exact boundary: a bound. It is the sum of what each round
  /// moved, or measured where that would be more than four units.
  double largest_movement = 0;
  double unit = 0;  ///< the distance of the numbers near the largest coordinate: one unit in the last place there
  std::uint64_t far_vertices = 0;         ///< vertices of the mesh that moved by more than four units
  std::uint64_t vanished_faces = 0;       ///< triangles of the exact boundary of which nothing is left
  std::uint64_t vanished_components = 0;  ///< sets of such triangles, connected over vertices, that no others touch
  /// Before and after, where faces were rearranged or vertices met; with Options::measure.
  std::optional<Topology> exact, rounded;
};

struct RoundedMesh {
  Mesh mesh;
  std::vector<std::uint32_t> source_face;  ///< per triangle, the triangle of the exact boundary that it is part of
  RoundingReport report;
};

/// The boundary of a solid, rounded to a grid such that it is the boundary of a solid again: the mesh is closed and
/// oriented, triangles meet in common vertices and edges alone (equal coordinates are one vertex), and winding numbers
/// are 0 and 1. `check` finds no error in it.
///
/// Every vertex takes the nearest coordinates of the grid, ties to even. Only triangles near vertices that moved can be
/// wrong then: cross others, have no area, or turn a shell inside out. Wrong ones are repaired: near vertices are
/// joined, flat triangles are flipped. What is wrong still is resolved exactly, as by `resolve`, and the vertices that
/// this makes are rounded in turn. Triangles that meet nothing stay as they are. Where the grid cannot hold a feature,
/// it vanishes: of a plate thinner than the grid nothing may be left, and the report says so. It ends for every input:
/// late rounds leave out bits. In practice two to ten rounds do, and nothing moves by more than a few units; where
/// large faces lie on each other within some units, it may be as many units as there are sheets, or more.
///
/// Laws: a mesh on the grid that bounds a solid is not changed; rounding the result again gives the result. Same bytes
/// for any number of threads. Requires that `mesh` bounds a solid, as ExactMesh of a Solid does. Of the options,
/// `threads`, `cancel` and `measure` count. Throws std::invalid_argument for a step as above is not, and for a
/// coordinate beyond the largest number of the format; Cancelled. O(n + m log m) to search for crossings near m
/// triangles that moved; the complexity of `resolve` for each time that faces are resolved. Source: own, after iterated
/// snap rounding (Halperin and Packer 2002); lib/core/round/theory.md.
[[nodiscard]] RoundedMesh round_to_solid(const ExactMesh& mesh, const CoordinateGrid& grid = {},
                                         const Options& options = {});

}  // namespace strata
