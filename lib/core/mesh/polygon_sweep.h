#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <stdexcept>
#include <vector>

#include "core/exact/sign.h"
#include "strata/mesh.h"

namespace strata {

/// A straight side between two different positions of a plane, numbered from left to right, and upwards where they are
/// above one another. The region is on its left.
struct PolygonSide {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
};

/// Sides that bound no region. what() gives the reason, without a subject.
class NoRegion : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Triangulates the region that closed polygons bound, by a sweep from left to right. The region may have holes and
/// several parts; polygons may meet themselves and each other in their corners. Triangles are counter-clockwise, none
/// is degenerate, none overlaps another. All sides are sides of triangles, so corners on straight stretches are kept.
/// No point is constructed.
///
/// Between two sides that cross the sweep line, the area that is not yet triangulated is bounded on its left by a chain
/// that curves towards it. A new position cuts off all triangles that it sees. If it lies between the two sides, the
/// chain is divided at its last position, which it sees. Source: Hertel and Mehlhorn 1983.
class PolygonSweep {
 public:
  /// Orientation of three positions, exact: positive when counter-clockwise.
  using Turn = std::function<Sign(std::uint32_t, std::uint32_t, std::uint32_t)>;

  /// Requires as many sides from every position as to it.
  PolygonSweep(std::span<const PolygonSide> sides, Turn orientation);
  PolygonSweep(const PolygonSweep&) = delete;
  PolygonSweep& operator=(const PolygonSweep&) = delete;

  /// O(n log n) orientation tests. Throws NoRegion when sides cross, overlap or pass through positions, or when what is
  /// on the left of a side is covered twice or is outside. The error is found before an invalid order is used, so the
  /// sweep always terminates.
  [[nodiscard]] std::vector<Triangle> divide();

 private:
  static constexpr std::uint32_t none = 0xffff'ffff;

  /// A side as used by the sweep: from its left to its right position.
  struct Edge {
    std::uint32_t left = 0, right = 0;
    bool bounds_above = false;  ///< the region is above it
  };
  struct Place {
    std::uint32_t number = 0;
  };
  /// The order from below of edges that meet one sweep line, and of positions on it.
  struct Below {
    using is_transparent = void;
    const Turn* orientation;

    bool operator()(const Edge& a, const Edge& b) const;
    bool operator()(const Edge& e, Place p) const {
      return (*orientation)(e.left, e.right, p.number) == Sign::positive;
    }
    bool operator()(Place p, const Edge& e) const {
      return (*orientation)(e.left, e.right, p.number) == Sign::negative;
    }
  };
  struct Node {
    std::uint32_t place = 0;
    std::uint32_t before = none, behind = none;
  };
  /// The left boundary of a part that is not yet triangulated, from below: nodes. `last` is the position swept last.
  struct Chain {
    std::uint32_t lowest = none, highest = none, last = none;
  };
  using Status = std::map<Edge, Chain, Below>;  ///< the chain belongs to the part above the edge, if there is one
  using At = Status::iterator;

  void pass(std::uint32_t place, std::span<Edge> starting);
  void open_between(At below, At above, std::uint32_t place, std::span<Edge> starting, bool inside, const Chain& upper);
  [[nodiscard]] Chain part(Chain& chain);
  [[nodiscard]] std::uint32_t add_node(std::uint32_t place);
  [[nodiscard]] bool sees(std::uint32_t lower, std::uint32_t place, std::uint32_t upper) const;
  void append(Chain& chain, std::uint32_t place);
  void prepend(Chain& chain, std::uint32_t place);
  void close(const Chain& chain, std::uint32_t place);
  void join(Chain& lower, const Chain& upper);
  void ensure_apart(At below, At above) const;

  Turn orientation_;
  std::vector<Edge> edges_;  ///< by their left positions
  Status status_;
  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;
};

}  // namespace strata
