#pragma once
#include "core/kernel/input_complex.h"
#include "core/overlap/constraint.h"
#include "core/overlap/filtered_face.h"

namespace strata {

/// Finds the intersection of two closed triangles, exactly, and appends the constraints on both.
///
/// Two triangles are apart, share a point, share a segment of the line in which their planes meet, or are coplanar and
/// overlap in a convex polygon. Each end of a shared segment is named by the lowest-dimensional features of both
/// triangles that contain it, so equal points get equal names wherever they are found. Vertices that two faces of one
/// mesh share by index are no meeting. Requires faces of positive area. At most 6 + 9 orient3d signs for faces in
/// general position. Table of cases: theory.md. Returns true when the faces share a point (other than shared vertices
/// and edges). Where `intersections` leaves coplanar faces, such a pair is listed there, and false is returned.
bool meet_faces(const InputComplex& input, const FilteredFace& f, const FilteredFace& g,
                PairIntersections& intersections);

/// The same for faces neither of which is beside the other. `of_f`: on which sides of g's plane the vertices of f are,
/// as doubles tell; `of_g`: the same for g and f's plane.
bool meet_faces(const InputComplex& input, const FilteredFace& f, const FilteredFace& g, Signs of_f, Signs of_g,
                PairIntersections& intersections);

}  // namespace strata
