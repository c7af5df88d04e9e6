#pragma once
#include <cstddef>
#include <cstdint>

#include "extensions/section/positions.h"
#include "strata/planar.h"

namespace strata {

/// A plane perpendicular to an axis, and how a mesh's vertices lie to it.
class AxisPlane {
 public:
  AxisPlane(std::size_t axis, double height, const ExactMesh& mesh)
      : axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3), height_(height), at_(mesh) {}

  [[nodiscard]] bool is_in_front(std::uint32_t v) const {
    const double z = at_.rounded(v)[axis_];
    if (z != height_) return z > height_;  // rounding is monotone
    const RationalPoint* p = at_.rational(v);
    return p != nullptr && (*p)[axis_] > to_rational(height_);
  }
  [[nodiscard]] bool contains(std::uint32_t v) const {
    if (at_.rounded(v)[axis_] != height_) return false;
    const RationalPoint* p = at_.rational(v);
    return p == nullptr || (*p)[axis_] == to_rational(height_);
  }
  [[nodiscard]] const Vertex& rounded(std::uint32_t v) const { return at_.rounded(v); }
  /// True where these are its exact coordinates.
  [[nodiscard]] bool is_double(std::uint32_t v) const { return at_.rational(v) == nullptr; }

  /// The point of the edge from a vertex not in front of the plane to one in front.
  [[nodiscard]] planar::RationalPlace crossing(std::uint32_t behind, std::uint32_t front) const {
    if (!is_double(behind) || !is_double(front)) return rational_crossing(behind, front);
    const Vertex &p = at_.rounded(behind), &q = at_.rounded(front);
    const planar::PlanePoint from{p[u_], p[v_]}, to{q[u_], q[v_]};
    if (p[axis_] == height_) return planar::PointBetween{from, from, 0, 2, 1};
    return planar::PointBetween{from, to, p[axis_], q[axis_], height_};
  }
  /// Adds that point to a loop.
  void add_crossing(std::uint32_t behind, std::uint32_t front, planar::LoopsBuilder& loops) const {
    loops.add_vertex(crossing(behind, front));
  }

 private:
  [[nodiscard]] planar::RationalPlacement rational_crossing(std::uint32_t behind, std::uint32_t front) const {
    const RationalPoint p = at_.exact(behind), q = at_.exact(front);
    const Rational h = to_rational(height_), below = h - p[axis_], above = q[axis_] - h, whole = below + above;
    const auto between = [&](std::size_t i) { return (p[i] * above + q[i] * below) / whole; };
    return {between(u_), between(v_)};
  }

  std::size_t axis_, u_, v_;
  double height_;
  Positions at_;
};

}  // namespace strata
