#pragma once
#include <algorithm>
#include <compare>
#include <cstdint>
#include <vector>

#include "core/kernel/point.h"
#include "core/overlap/point_table.h"

namespace strata {

/// The line on which a constraint lies inside a face: an input edge, or the trace of another face's plane.
struct ConstraintLine {
  std::uint32_t a = 0, b = 0;  ///< edge: its vertices, a < b. trace: a = b = the other face
  bool edge = false;

  static ConstraintLine along_edge(std::uint32_t u, std::uint32_t v) { return {std::min(u, v), std::max(u, v), true}; }
  static ConstraintLine trace_of(std::uint32_t face) { return {face, face, false}; }
  friend auto operator<=>(const ConstraintLine&, const ConstraintLine&) = default;
};

/// The effect of another face on a face along a constraint. Left and right are seen looking along tail -> head with the
/// face's outward normal up. "Above" is the outer side of the face.
enum class ConstraintKind : std::uint8_t {
  point,     ///< the faces share one point (tail = head)
  touch,     ///< the other face has an edge here and is nowhere above: no winding number changes across it
  crossing,  ///< just above the face, the winding number about the other operand is one higher on the left than on the
             ///< right
  cover_left,   ///< an edge of a coplanar face that covers the left side
  cover_right,  ///< an edge of a coplanar face that covers the right side
  coplanar,     ///< the other face lies in the same plane and may cover parts; no geometry (tail, head: a corner)
};

/// A point or segment in which a face meets another face, exactly.
struct Constraint {
  std::uint32_t face = 0;   ///< the face it constrains
  std::uint32_t other = 0;  ///< the face it meets
  ConstraintKind kind = ConstraintKind::point;
  ConstraintLine line;
  PointId tail = 0, head = 0;
};

/// Two input vertices with equal coordinates.
struct EqualVertices {
  std::uint32_t a = 0, b = 0;
  friend auto operator<=>(const EqualVertices&, const EqualVertices&) = default;
};

/// Two faces, the lower number first.
struct FacePair {
  std::uint32_t face = 0, other = 0;
};

/// The intersections of some pairs of faces, collected pair by pair.
struct PairIntersections {
  /// The number of a point: its own if it is an input vertex, else the vertex count plus its index in `constructed`. A
  /// constructed point is appended to that list unless it is among the last entries.
  [[nodiscard]] PointId number(const InputComplex& input, const SymbolicPoint& name);

  void clear() {
    constraints.clear();
    constructed.clear();
    equal.clear();
    coplanar.clear();
  }

  std::vector<Constraint> constraints;
  std::vector<SymbolicPoint> constructed;
  std::vector<EqualVertices> equal;
  std::vector<FacePair> coplanar;   ///< pairs that may overlap in one plane and are not intersected yet
  bool leaves_coplanar = false;     ///< such pairs are only listed, unless they have the same vertices
  std::uint64_t pairs_tested = 0;   ///< pairs whose boxes overlap
  std::uint64_t pairs_meeting = 0;  ///< pairs that share a point
};

}  // namespace strata
