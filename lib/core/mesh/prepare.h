#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/exact/sign.h"
#include "core/kernel/box.h"
#include "strata/check.h"
#include "strata/errors.h"
#include "strata/mesh.h"
#include "strata/options.h"

namespace strata {

/// What one streaming pass over a mesh can tell.
struct Screening {
  bool finite = true;         ///< every coordinate of a used vertex is finite
  bool indices_valid = true;  ///< every index names a vertex
  bool chain_closed = true;   ///< directed edges cancel: random linear hash, wrong with probability < 2^-60
  bool degenerate = false;    ///< some triangle has zero area, decided exactly
  int orientation = 0;        ///< sign of the signed volume, exact; 0 too unless closed, finite and valid
  Box bounds;                 ///< of the vertices used, where all are finite and valid
};

/// Streams once over vertices and triangles, in parallel. O(n), no allocation in proportion to n.
/// Decisions are made in doubles with proven error bounds, and exactly where these do not suffice.
/// A mesh without triangles is closed and has orientation 0.
[[nodiscard]] Screening screen(MeshView mesh);

/// Screening::chain_closed alone.
[[nodiscard]] bool chain_is_closed(MeshView mesh);

/// An operand made ready for the engine. `mesh` is empty when the input can be used as it is.
struct Prepared {
  std::optional<Mesh> mesh;                ///< replaces the input
  std::vector<std::uint32_t> source_face;  ///< input face per triangle of `mesh`
  std::vector<Defect> notes;               ///< what was resolved, exactly
  std::optional<Box> bounds;               ///< a box of the vertices used, if one was found on the way
};

/// Accepts a closed oriented mesh (`solid` and `overlapping` input).
/// A chain that is open only because equal vertices are listed twice is welded on equal coordinates (-0 = 0).
/// Zero-area triangles are removed: the edges of their neighbours are divided at the vertices that lie inside them,
/// so that the boundary stays closed and no point moves.
/// `allow_inside_out` keeps a negative volume from being an error.
/// Throws InputError with the full diagnosis otherwise. An empty mesh is the empty solid.
[[nodiscard]] Prepared prepare_closed(MeshView mesh, bool allow_inside_out, std::size_t operand = 0);

/// Accepts a closed oriented mesh whose vertices may be rationals, by exact tests on these: a mesh that is closed but
/// for vertices listed twice is welded, as above; nothing else is resolved, so triangles of zero area are refused.
/// Throws InputError with the full diagnosis, std::invalid_argument when `exact` is not by increasing index or the mesh
/// does not hold the nearest doubles. O(n) and rational arithmetic where doubles do not decide.
[[nodiscard]] Prepared prepare_exact(ExactMeshView mesh, std::size_t operand = 0);

/// Sign of the signed volume of a closed mesh, exact. O(n), rational where doubles do not decide.
[[nodiscard]] Sign orientation(ExactMeshView mesh);

/// Makes a closed oriented mesh of a soup: drops faces with indices out of range or coordinates that are not finite,
/// welds equal vertices, drops degenerate and duplicate faces (opposite pairs cancel), orients components
/// consistently and outwards; every step is a note. Throws InputError when edges stay open.
[[nodiscard]] Prepared prepare_soup(MeshView mesh, std::size_t operand = 0);

/// Accepts a mesh as what the caller declares it to be, by the function above that is meant for it: `prepare_exact` if
/// it has vertices that are not doubles, whatever its class; else `prepare_closed` for `solid` and `overlapping`, and
/// `prepare_soup` for `repair`. Throws as these do.
[[nodiscard]] Prepared prepare(ExactMeshView mesh, InputClass input, std::size_t operand = 0);

}  // namespace strata
