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
  /// False for no vertex in the plane; true also for some that are rational and near it.
  [[nodiscard]] bool is_near(std::uint32_t v) const { return at_.rounded(v)[axis_] == height_; }
  [[nodiscard]] const Vertex& rounded(std::uint32_t v) const { return at_.rounded(v); }
  /// True where these are its exact coordinates.
  [[nodiscard]] bool is_double(std::uint32_t v) const { return at_.rational(v) == nullptr; }

  /// The point of the edge from a vertex behind the plane to one in front.
  [[nodiscard]] planar::RationalPlace crossing(std::uint32_t behind, std::uint32_t front) const {
    if (!is_double(behind) || !is_double(front)) return rational_crossing(behind, front);
    const Vertex &p = at_.rounded(behind), &q = at_.rounded(front);
    return planar::PointBetween{{p[u_], p[v_]}, {q[u_], q[v_]}, p[axis_], q[axis_], height_};
  }
  /// Adds that point to a loop. The first vertex may be in the plane.
  void add_crossing(std::uint32_t behind, std::uint32_t front, planar::LoopsBuilder& loops) const {
    const Vertex& p = at_.rounded(behind);
    if (p[axis_] == height_ && is_double(behind)) return loops.add_vertex(planar::PlanePoint{p[u_], p[v_]});
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
