#pragma once
#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/containers/pool.h"
#include "core/kernel/input_complex.h"
#include "core/overlap/intersect.h"
#include "core/select/classifier.h"
#include "strata/options.h"

namespace strata {

/// A triangle of the subdivision that bounds the result, by indices into SubdividedFace::points. Its orientation is
/// that of the result.
struct PieceTriangle {
  std::array<std::uint32_t, 3> v{};
  /// Bit i: beyond side i (v[i] to v[i + 1]) no triangle of this face bounds the result with the same orientation.
  std::uint8_t boundary = 0;
  std::uint8_t carried = 0;  ///< bit i: side i lies on a constraint
  bool reversed = false;     ///< its orientation is opposite to that of its face
};

/// A face that contains a piece of another, lower one.
struct Cover {
  std::uint32_t triangle = 0;  ///< the piece
  std::uint32_t face = 0;
};

/// The pieces of one face with intersections that bound the result. The arrays are in pools.
struct SubdividedFace {
  std::uint32_t face = 0;
  bool may_merge = false;  ///< the face is subdivided by more than the proper crossing of two operands
  std::span<PointId> points;
  std::span<PieceTriangle> triangles;
  std::span<Cover> covers;  ///< by increasing piece and face, where the rule keeps them
};

/// One pool per thread.
using Pools = tbb::enumerable_thread_specific<Pool>;

/// All faces with intersections, subdivided.
struct Subdivision {
  std::vector<SubdividedFace> faces;  ///< by increasing face
  Pools pools;                        ///< hold the arrays of the faces
  PointTable points;                  ///< with the points constructed while faces were subdivided
};

/// Subdivides every face that has constraints, and labels each piece. Pieces are labelled here, and not in `label`,
/// because a subdivision that is dropped as soon as its pieces are labelled stays in the cache, and because many faces
/// are known to have no piece in the result before they are subdivided (EarlyOut).
///
/// The winding numbers at one point of a face come from the oracle. Those of all other pieces follow across the
/// constraints, each of which determines how they change. The winding numbers below a piece are those above it plus the
/// contributions of the piece and of the coplanar pieces on it. Of coincident pieces, the one of the lowest face
/// represents all. Points found equal are identified in the table of points. Throws Cancelled.
[[nodiscard]] Subdivision subdivide(const InputComplex& input, Intersections intersections,
                                    const Classifier& classifier, const Monitor& monitor);

}  // namespace strata
