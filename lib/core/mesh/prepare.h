#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/exact/sign.h"
#include "core/kernel/box.h"
#include "strata/check.h"
#include "strata/errors.h"
#include "strata/mesh.h"
#include "strata/monitor.h"
#include "strata/options.h"

namespace strata {

/// The facts about a mesh that one streaming pass can find.
struct Screening {
  bool finite = true;         ///< every coordinate of a used vertex is finite
  bool indices_valid = true;  ///< every index names a vertex
  bool chain_closed = true;   ///< directed edges cancel: random linear hash, wrong with probability < 2^-60
  bool degenerate = false;    ///< some triangle has zero area, decided exactly
  int orientation = 0;        ///< sign of the signed volume, exact; 0 too unless closed, finite and valid
  Box bounds;                 ///< of the vertices used, where all are finite and valid
};

/// One parallel streaming pass over vertices and triangles. O(n), no allocation in proportion to n. Decisions are made
/// in doubles with proven error bounds, and exactly where these do not suffice. A mesh without triangles is closed and
/// has orientation 0.
[[nodiscard]] Screening screen(MeshView mesh, const Monitor& monitor = {});

/// Only Screening::chain_closed.
[[nodiscard]] bool chain_is_closed(MeshView mesh, const Monitor& monitor = {});

/// An operand that satisfies what the engine requires: closed and oriented, without degenerate triangles. `mesh` is
/// empty when the input itself does.
struct Prepared {
  std::optional<Mesh> mesh;                ///< replaces the input
  std::vector<std::uint32_t> source_face;  ///< input face per triangle of `mesh`
  std::vector<Defect> notes;               ///< the defects that were resolved, exactly
  std::optional<Box> bounds;               ///< a box of the vertices used, if one was computed
};

/// Accepts a closed oriented mesh (`solid` and `overlapping` input). A mesh that is open only because equal vertices
/// are listed twice is welded on equal coordinates (-0 = 0). Zero-area triangles are removed: the edges of their
/// neighbours are divided at the vertices that lie inside them, so that the boundary remains closed and no point moves.
/// With `allow_inside_out` a negative volume is no error. Throws InputError with the full diagnosis otherwise. An empty
/// mesh is the empty solid.
[[nodiscard]] Prepared prepare_closed(MeshView mesh, bool allow_inside_out, std::size_t operand = 0,
                                      const Monitor& monitor = {});

/// Accepts a closed oriented mesh whose vertices may be rationals, by exact tests on these. A mesh that is open only
/// because vertices are listed twice is welded, as above. No other defect is resolved, so triangles of zero area are
/// refused. Throws InputError with the full diagnosis, std::invalid_argument when `exact` is not by increasing index or
/// the mesh does not hold the nearest doubles. O(n), with rational arithmetic where doubles do not decide.
[[nodiscard]] Prepared prepare_exact(ExactMeshView mesh, std::size_t operand = 0, const Monitor& monitor = {});

/// Sign of the signed volume of a closed mesh, exact. O(n), rational where doubles do not decide.
[[nodiscard]] Sign orientation(ExactMeshView mesh, const Monitor& monitor = {});

/// What becomes of loops of open edges.
enum class Holes : bool { refused, filled };

/// Constructs a closed oriented mesh from a soup: drops faces with indices out of range or coordinates that are not
/// finite, welds equal vertices, drops degenerate and duplicate faces (opposite pairs cancel, but where nothing would
/// be left that encloses something, one of each stays), orients components consistently and outwards. Every step adds a
/// note. Open edges that remain are filled, or refused with InputError. Where holes are filled, a mesh that is closed
/// and consistent keeps its orientation, and faces that enclose no volume are refused, and so are loops of more edges
/// than given.
[[nodiscard]] Prepared prepare_soup(MeshView mesh, Holes holes, std::size_t operand = 0,
                                    std::size_t most_edges = std::numeric_limits<std::size_t>::max(),
                                    const Monitor& monitor = {});

/// Accepts a mesh as what the caller declares it to be, by the function above that is meant for it: `prepare_exact` if
/// it has vertices that are not doubles, whatever its class; else `prepare_closed` for `automatic`, `solid` and
/// `overlapping`, and `prepare_soup` for `repair` and `soup`. Throws as these do. Of the options, `input`,
/// `most_hole_edges` and `cancel` count.
[[nodiscard]] Prepared prepare(ExactMeshView mesh, const Options& options, std::size_t operand = 0);

}  // namespace strata
