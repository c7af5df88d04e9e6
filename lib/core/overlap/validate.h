#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/overlap/intersect.h"
#include "core/overlap/point_table.h"

namespace strata {

/// What does not hold of the intersections of faces; empty: nothing.
///
/// Of all constraints: those of one face are adjacent, by increasing face; the other face is another one that exists
/// and has a constraint with this one; ends are points of the table, equal ones exactly where the kind is `point` or
/// `coplanar`; edges are such of one of the two faces. Of a sample, by exact predicates: both ends lie on the closed
/// triangles of both faces; equal vertices are at one place. O(n log n).
[[nodiscard]] std::vector<std::string> validate(const InputComplex& input, const Intersections& intersections);

/// What does not hold of a table of points; empty: nothing.
///
/// Names are distinct. Of a sample: coordinates are within their bounds; identified points are at one place. O(n log
/// n).
[[nodiscard]] std::vector<std::string> validate(const InputComplex& input, const PointTable& points);

/// The first part of it, of the constructed points alone, numbered from `first`.
[[nodiscard]] std::vector<std::string> validate(const InputComplex& input, std::span<const Point> constructed,
                                                PointId first);

/// Of these points of the table, or a sample of them: those that represent themselves have different positions, except
/// vertices that one operand lists twice. O(n log n).
[[nodiscard]] std::vector<std::string> validate_distinct(const InputComplex& input, const PointTable& points,
                                                         std::vector<PointId> ids);

}  // namespace strata
