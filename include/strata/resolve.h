#pragma once
/// A closed mesh that crosses and overlaps itself, made a solid.
#include "strata/mesh.h"
#include "strata/options.h"
#include "strata/solid.h"

namespace strata {

/// The solid of the points inside a mesh, regularized: faces are cut where they cross, and those between two inner or
/// two outer points go. Exact, as `combine` is. Laws: a solid stays as it is, as a point set; resolving twice is
/// resolving once; the results for `winding` and `even_odd` are parts of that for `outer`. Degenerate cases are those
/// of `combine` for operands of class `overlapping`: sheets may coincide any number of times.
///
/// Of the options, `input` says what is accepted: `automatic`, `solid` and `overlapping` a closed mesh, `repair` and
/// `soup` any triangles. Sources: operand 0 is the mesh. Notes: what was resolved. Throws InputError where the mesh is
/// not closed, or, for Inside::winding, has a negative volume; Cancelled; std::length_error. Complexity: that of
/// `combine`.
[[nodiscard]] Solid resolve(ExactMesh mesh, Inside inside = Inside::winding, const Options& options = {});

}  // namespace strata
