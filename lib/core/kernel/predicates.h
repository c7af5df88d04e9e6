#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "core/exact/double_double.h"
#include "core/exact/sign.h"
#include "core/kernel/filtered_orientation.h"
#include "core/kernel/filters.h"
#include "core/kernel/input_complex.h"
#include "core/kernel/point.h"

namespace strata {

/// All decisions of the engine. Each is exact for every finite input, at any scale. The tiers are: running errors in
/// doubles; zeros that follow from names; running errors in double-doubles; integers of fixed width on the lattice of
/// the coordinates concerned; unbounded integers. Degrees, widths and bounds: theory.md. O(1); thread-safe.

/// Two coordinate axes along which a plane projects without degenerating to a line, in the order in which a given face
/// is counter-clockwise.
struct Projection {
  int u = 0;
  int v = 1;
};

/// Side of s relative to the oriented plane through p, q, r.
/// positive: s sees p, q, r counter-clockwise, that is, s is on the outer side; zero: coplanar.
/// Laws: swapping two arguments negates the sign.
/// Source: Shewchuk 1997 (his sign is the opposite).
[[nodiscard]] Sign orient3d(const InputComplex& input, const Point& p, const Point& q, const Point& r, const Point& s);

/// The same for four input vertices. This is the most frequent decision of the engine.
[[nodiscard]] Sign orient3d(const InputComplex& input, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                            std::uint32_t d);

/// The same for points given by their doubles, without an input complex.
[[nodiscard]] Sign orient3d(const InputComplex::Coordinates& a, const InputComplex::Coordinates& b,
                            const InputComplex::Coordinates& c, const InputComplex::Coordinates& d);

/// Sign of ((q - p) x (r - p)) . direction: orient3d(p, q, r, s) for an s infinitely far away in that direction.
[[nodiscard]] Sign normal_along(const InputComplex& input, const Point& p, const Point& q, const Point& r,
                                const InputComplex::Coordinates& direction);

/// Side of p relative to the plane of a face: positive on its outer side.
[[nodiscard]] Sign side_of_face(const InputComplex& input, std::uint32_t face, const Point& p);

/// The first tier and names alone: nullopt when these do not decide.
[[nodiscard]] std::optional<Sign> filtered_side_of_face(const InputComplex& input, std::uint32_t face, const Point& p);

/// Orientation of p, q, r in the projection: positive when counter-clockwise; zero when collinear there.
[[nodiscard]] Sign orient2d(const InputComplex& input, Projection projection, const Point& p, const Point& q,
                            const Point& r);

/// The same for points given by their doubles, without an input complex.
[[nodiscard]] Sign orient2d(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

/// The first tier of orient2d alone: nullopt when running errors do not decide.
[[nodiscard]] std::optional<Sign> filtered_orient2d(Projection projection, const Point& p, const Point& q,
                                                    const Point& r);

/// The second tier of orient2d alone, by double-doubles and exact differences: nullopt when it does not decide.
[[nodiscard]] std::optional<Sign> refined_orient2d(Projection projection, const Point& p, const Point& q,
                                                   const Point& r);

/// The last tier of orient2d alone: integers.
[[nodiscard]] Sign exact_orient2d(const InputComplex& input, Projection projection, const Point& p, const Point& q,
                                  const Point& r);

/// Sign of p[axis] - q[axis].
[[nodiscard]] Sign compare(const InputComplex& input, int axis, const Point& p, const Point& q);

/// True when both points have the same position.
[[nodiscard]] bool equal(const InputComplex& input, const Point& p, const Point& q);

/// Sign of one component of the outward normal (b-a)x(c-a) of a face.
[[nodiscard]] Sign normal_component(const InputComplex& input, std::uint32_t face, int axis);

/// Sign of the dot product of two faces' outward normals. Requires coplanar faces of positive area.
[[nodiscard]] Sign same_orientation(const InputComplex& input, std::uint32_t f, std::uint32_t g);

/// A projection for the plane of a face. Requires a face of positive area.
[[nodiscard]] Projection projection_of(const InputComplex& input, std::uint32_t face);

/// Sign of the area of a closed polygon of doubles in the plane, every part counted with its winding number: positive
/// when counter-clockwise. Laws: reversing the polygon negates the sign; another start does not change it. O(n).
[[nodiscard]] Sign area_sign(std::span<const PlanePoint> polygon);

/// True when the three vertices of a face are collinear.
[[nodiscard]] bool is_degenerate(const InputComplex& input, std::uint32_t face);

}  // namespace strata
