#pragma once
#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>

#include "core/exact/bounded.h"
#include "core/exact/double_double.h"
#include "core/kernel/filters.h"
#include "core/kernel/input_complex.h"

namespace strata {

/// The name of a point: the input features that meet in it, its defining features. Equal names are equal points.
/// Different names may be equal points too (four planes through one point); `equal` decides that exactly.
///
/// | kind        | ids                | the point                                                        |
/// |-------------|--------------------|------------------------------------------------------------------|
/// | input       | v                  | vertex v                                                         |
/// | edge_edge   | a < b, c < d       | where the lines ab and cd meet; they are coplanar, not parallel  |
/// | edge_face   | a < b, f           | where the line ab meets the plane of face f; not parallel        |
/// | three_faces | f < g < h          | where the planes of three faces meet; normals independent        |
/// | weighted    | f, t               | (p + t q + t^2 r) / (1 + t + t^2) for the corners p, q, r of f   |
/// | free        | -                  | any doubles, held by the Point itself                            |
struct SymbolicPoint {
  enum class Kind : std::uint8_t { input, edge_edge, edge_face, three_faces, weighted, free };

  Kind kind = Kind::free;
  std::array<std::uint32_t, 4> id{};

  static SymbolicPoint input(std::uint32_t v) { return {Kind::input, {v, 0, 0, 0}}; }
  static SymbolicPoint edge_face(std::uint32_t a, std::uint32_t b, std::uint32_t f) {
    return {Kind::edge_face, {std::min(a, b), std::max(a, b), f, 0}};
  }
  static SymbolicPoint edge_edge(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    std::array<std::uint32_t, 2> e{std::min(a, b), std::max(a, b)}, g{std::min(c, d), std::max(c, d)};
    if (g < e) std::swap(e, g);
    return {Kind::edge_edge, {e[0], e[1], g[0], g[1]}};
  }
  static SymbolicPoint three_faces(std::uint32_t f, std::uint32_t g, std::uint32_t h) {
    std::array<std::uint32_t, 3> s{f, g, h};
    std::sort(s.begin(), s.end());
    return {Kind::three_faces, {s[0], s[1], s[2], 0}};
  }
  /// Requires t <= weight_limit.
  static SymbolicPoint weighted(std::uint32_t f, std::uint32_t t) { return {Kind::weighted, {f, t, 0, 0}}; }
  static constexpr std::uint32_t weight_limit = 1u << 24;

  friend auto operator<=>(const SymbolicPoint&, const SymbolicPoint&) = default;
};

/// A point with a name and bounded approximations of its coordinates. The name determines the point; the bounds make
/// most decisions fast.
struct Point {
  SymbolicPoint name;
  BoundedPoint at;               ///< for the first tier
  RealPoint<DoubleDouble> fine;  ///< for the second tier

  /// A point at given doubles.
  static Point free(const InputComplex::Coordinates& p) {
    return {SymbolicPoint{}, {p[0], p[1], p[2]}, {p[0], p[1], p[2]}};
  }
};

/// True when the name shows that the point lies in the plane of face f, whose vertices are v.
[[nodiscard]] bool named_on_face(const SymbolicPoint& name, std::uint32_t f, const InputComplex::Indices& v);

/// True when the name shows that the point lies on the line through the vertices a and b.
[[nodiscard]] bool named_on_edge(const SymbolicPoint& name, std::uint32_t a, std::uint32_t b);

/// True when the names show that the point lies on the line through two other points: all are on one edge, or in the
/// same two of the planes that define it. O(1).
[[nodiscard]] bool named_on_line(const InputComplex& input, const SymbolicPoint& name, const SymbolicPoint& p,
                                 const SymbolicPoint& q);

/// Approximates the symbolic point. Its coordinates are within the bounds, which are about an ulp wide. Where the
/// defining features meet at an angle so small that double-doubles do not reach this, the coordinates are computed from
/// the exact position. Requires a kind other than free, and defining features that meet in one point. O(1), with
/// rationals in the ill-conditioned case.
[[nodiscard]] Point make_point(const InputComplex& input, const SymbolicPoint& name);

/// The exact position of a point. O(1) rational operations.
[[nodiscard]] RationalPoint exact_position(const InputComplex& input, const Point& point);

/// The double nearest to each exact coordinate, ties to even.
[[nodiscard]] InputComplex::Coordinates nearest_doubles(const InputComplex& input, const Point& point);

}  // namespace strata
