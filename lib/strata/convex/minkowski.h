#pragma once
#include <span>

#include "strata/convex/polytope.h"
#include "strata/csg/options.h"
#include "strata/csg/solid.h"

namespace strata::convex {

/// The Minkowski sum {x + y : x in a, y in b} of two solids: any genus, cavities, several parts, edges and vertices of
/// several sheets. Empty if one of them is. Exact; regular as it is, since a solid plus anything is.
/// Laws: commutative; A + point is a translation; (A + B) + C = A + (B + C); monotone in both.
/// Two convex solids are added by their Gauss maps; else the faces in which both may touch, sums of faces, vertices and
/// pairs of edges with outward directions in common, are arranged, and the pieces on the outside are the boundary.
/// theory.md, "Minkowski sums", has the proof.
/// Of the options, the class of input and the engine are ignored. Throws Cancelled, std::overflow_error where a
/// coordinate is beyond all doubles, std::length_error as `combine` does.
[[nodiscard]] Solid minkowski_sum(const Solid& a, const Solid& b, const Options& options = {});

/// The same for a polytope of any dimension: a point moves the solid, a segment sweeps it.
[[nodiscard]] Solid minkowski_sum(const Solid& a, const Polytope& b, const Options& options = {});

/// The sum of a solid and the union of some polytopes, such as the triangles of an open surface.
[[nodiscard]] Solid minkowski_sum(const Solid& a, std::span<const Polytope> b, const Options& options = {});

/// Where b fits: {x : x + b within a}, regularized (without parts that have no volume). a, if b is empty, would be all
/// of space: then throws std::invalid_argument. Laws: the largest solid X with X + b within a, but for parts without
/// volume; erosion(minkowski_sum(a, b), b) contains a.
[[nodiscard]] Solid erosion(const Solid& a, const Solid& b, const Options& options = {});
[[nodiscard]] Solid erosion(const Solid& a, const Polytope& b, const Options& options = {});

/// The polytope turned about the origin: {-x}.
[[nodiscard]] Polytope reflected(const Polytope& polytope);

}  // namespace strata::convex
