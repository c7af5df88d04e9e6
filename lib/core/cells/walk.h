#pragma once
#include <cstdint>

#include "core/kernel/predicates.h"

namespace strata {

/// The crossings of a walk with faces, counted exactly. A walk is the segment from an origin to a point.
///
/// An origin O represents the point O' = O + (e, e^2, e^3) with an infinitely small e > 0, the same for all origins of
/// an evaluation. O' is on no face plane and on no line or plane spanned by face vertices and another point of a finite
/// set. So its winding numbers are defined wherever O is, and walks between such points meet faces in their interiors
/// only. Signs of O' are those of O; where these are zero, that of the first partial derivative that is not zero. Only
/// the walk is perturbed, never a surface. Proofs: theory.md.

/// Side of O' relative to a face: positive on the outer side, never zero for a face of positive area.
[[nodiscard]] Sign side_of_origin(const InputComplex& input, std::uint32_t face,
                                  const InputComplex::Coordinates& origin);

/// Change of the winding number of `face`'s operand along the walk from O' to q: +1 where the walk enters through the
/// face, -1 where it leaves, 0 where it does not cross. A face whose plane contains q counts as not crossed; the caller
/// handles contact.
[[nodiscard]] int crossing(const InputComplex& input, std::uint32_t face, const InputComplex::Coordinates& origin,
                           const Point& q);

/// True when the line through an origin along an axis crosses the face. On it, the walk from one origin to another
/// crosses the face if they are on different sides of it.
[[nodiscard]] bool is_crossed_along_axis(const InputComplex& input, std::uint32_t face,
                                         const InputComplex::Coordinates& origin, int axis);

/// `crossing` along the walk from one origin to another that differs from it in one coordinate only.
[[nodiscard]] int crossing_along_axis(const InputComplex& input, std::uint32_t face,
                                      const InputComplex::Coordinates& from, const InputComplex::Coordinates& to,
                                      int axis);

/// An origin infinitely far away, from which walks run along a direction d, represents d' = d + (e, e^2, e^3): the same
/// laws, with d' in place of the vector from O' to q.
///
/// Side of that origin relative to a face: positive on the outer side, never zero for a face of positive area.
[[nodiscard]] Sign side_of_infinity(const InputComplex& input, std::uint32_t face,
                                    const InputComplex::Coordinates& direction);

/// Change of the winding number of `face`'s operand along the walk to q from infinity, as `crossing`.
[[nodiscard]] int crossing_from_infinity(const InputComplex& input, std::uint32_t face,
                                         const InputComplex::Coordinates& direction, const Point& q);

}  // namespace strata
