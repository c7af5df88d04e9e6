#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "strata/planar/places.h"

namespace strata::plane {

/// Polyloops: cyclic lists of vertices, each joined to the next by an edge. Nothing more is asked of them: they may
/// cross themselves and each other, touch, run back along themselves, or consist of one vertex.
///
/// An edge lies on the line through its ends, or, if one of them is a meet, on a given line that `edge_line` names; so
/// results of operations remember where their edges came from. Points that are no vertices are there for the lines that
/// need them.
struct Loops {
  Places places;
  std::vector<std::uint32_t> vertices;  ///< of all loops, one loop after the other
  std::vector<std::uint32_t>
      edge_line;  ///< of the edge from vertex i to the next; none: the line through both (given) ends
  std::vector<std::uint32_t> first_vertex{0};  ///< of every loop, in `vertices`, and the count

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(first_vertex.size() - 1); }
  [[nodiscard]] std::span<const std::uint32_t> loop(std::uint32_t i) const {
    return {vertices.data() + first_vertex[i], vertices.data() + first_vertex[i + 1]};
  }
  /// Appends a loop of points given as doubles. Requires finite ones, and that no other points are there.
  void add(std::span<const PlanePoint> loop);
};

/// Collects loops of points that are doubles or rationals.
class LoopsBuilder {
 public:
  void add_vertex(const PlanePoint& p);
  void add_vertex(RationalPlacement p);  ///< rationals that are doubles are taken as such
  void end_loop();
  [[nodiscard]] Loops finish();

 private:
  std::vector<PlanePoint> doubles_;
  std::vector<RationalPlacement> rationals_;
  std::vector<std::array<std::uint32_t, 2>> vertices_;  ///< 0 and a double's number, or 1 and a rational's
  std::vector<std::uint32_t> first_vertex_{0};
};

/// Loops from lists of points.
[[nodiscard]] Loops loops_of(std::span<const std::vector<PlanePoint>> loops);

/// Twice the area that the loops wind around, counter-clockwise positive: the sum of vertex cross products. Exact;
/// rationals of meets grow with their number, so this takes O(k log k) operations on numbers of up to k times the size
/// of one meet.
[[nodiscard]] Rational twice_area(const Loops& loops, std::span<const std::uint32_t> loop);
[[nodiscard]] Rational twice_area(const Loops& loops);

}  // namespace strata::plane
