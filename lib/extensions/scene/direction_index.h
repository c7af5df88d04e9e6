#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "extensions/scene/direction_charts.h"
#include "strata/query.h"

namespace strata {

/// A square of a chart's grid, half-open.
struct ChartSquare {
  std::array<std::int32_t, 2> lower{};
  std::int32_t side = 0;

  [[nodiscard]] bool holds(std::int32_t u, std::int32_t v) const {
    return lower[0] <= u && u - lower[0] < side && lower[1] <= v && v - lower[1] < side;
  }
};

/// Quarters (0, 0), (1, 0), (0, 1), (1, 1).
[[nodiscard]] inline ChartSquare quarter_of(const ChartSquare& s, std::size_t i) {
  const std::int32_t half = s.side / 2;
  return {{s.lower[0] + static_cast<std::int32_t>(i % 2) * half, s.lower[1] + static_cast<std::int32_t>(i / 2) * half},
          half};
}

/// The position of a face in a chart: a closed rectangle of the chart's grid.
struct Footprint {
  std::uint32_t face = 0;
  std::array<std::int32_t, 2> lower{}, upper{};
  /// Spans many squares. Then its edges, not only the rectangle, decide in which squares it is listed.
  bool is_large = false;
  float near = 0;  ///< no point of the face has less depth
};

/// All faces of a scene by the directions in which they are seen from an origin. Each chart has a grid of squares,
/// subdivided into quarters where many faces are. Every direction is in one square of a chart, whose list has all faces
/// that the direction meets, and a few more. Nothing is decided here: lists are conservative by bounds on rounding.
/// Memory O(faces) unless faces are stacked. A query is O(log) and takes constant time except in dense directions.
class DirectionIndex {
 public:
  DirectionIndex() = default;
  /// O(n log n), in parallel.
  DirectionIndex(const Scene& scene, const Origin& origin, const Monitor& monitor);

  /// Calls `visit(face)` once for every face that the walk from the origin to q meets, q included, and for a few more,
  /// judged by rectangles and depths in one list, unless q's direction has too large an error. Requires that q is not
  /// the origin. Faces that contain the origin are left out.
  template <class Visit>
  void for_each_towards(const BoundedPoint& q, const Visit& visit) const {
    if (const auto list = list_towards(q)) {
      for (const Entry& e : list->entries)
        if (e.reaches(*list)) visit(e.face);
    } else {
      for (const std::uint32_t f : gather_towards(q)) visit(f);
    }
  }

  /// Faces that contain the origin, also on their edges and corners.
  [[nodiscard]] std::span<const std::uint32_t> faces_at_origin() const { return at_origin_; }

  struct Leaf {
    std::size_t chart = 0;
    ChartSquare square;
    std::span<const std::uint32_t> footprints;  ///< numbers in `footprints(chart)`
  };
  /// Calls `visit(leaf)` for every square with two faces or more, in parallel, in no order. Footprints exist until they
  /// are forgotten.
  template <class Visit>
  void for_each_leaf(const Visit& visit) const;
  [[nodiscard]] std::span<const Footprint> footprints(std::size_t chart) const { return charts_[chart].footprints; }

  /// Frees what only `for_each_leaf` and `footprints` need.
  void forget_footprints();

  [[nodiscard]] std::size_t bytes() const;

 private:
  friend class DirectionIndexBuilder;
  static constexpr std::int32_t grid_bits = 30;
  static constexpr std::uint32_t is_inner = 0xffffffffu;

  /// Leaf: `count` entries from `first`. Inner: four quarters from node `first`.
  struct Node {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  /// The faces listed for the direction of a point, and the point's position there.
  struct List;
  /// A face in a list, with data that excludes it for most walks.
  struct Entry {
    std::uint32_t face = 0;
    float near = 0;
    std::array<std::int32_t, 2> lower{}, upper{};

    [[nodiscard]] bool reaches(const List& to) const;
  };
  struct List {
    std::span<const Entry> entries;
    std::int32_t u = 0, v = 0;
    double depth = 0;  ///< bound from above
  };
  /// The first nodes are those of a grid of 2^bits by 2^bits squares.
  struct Chart {
    std::array<double, 2> lower{}, scale{};  ///< grid coordinate = (u - lower) * scale
    std::int32_t bits = 0;
    std::vector<Node> nodes;
    std::vector<Entry> entries;
    std::vector<std::uint32_t> entry_footprints;  ///< the same as numbers of footprints
    std::vector<Footprint> footprints;

    [[nodiscard]] std::int32_t grid(std::size_t axis, double u) const;
    [[nodiscard]] const Node& leaf_at(std::int32_t u, std::int32_t v) const;
  };
  struct Range {
    std::int32_t first, last;
  };
  /// Grid coordinates of a direction; empty (first > last) where it is certainly not in the chart's domain.
  [[nodiscard]] Range range_of(const Chart& chart, std::size_t axis, const ChartVector& r) const;
  [[nodiscard]] std::optional<List> list_towards(const BoundedPoint& q) const;
  [[nodiscard]] std::vector<std::uint32_t> gather_towards(const BoundedPoint& q) const;
  template <class Visit>
  static void visit_leaves(const Chart& chart, const Node& node, const ChartSquare& square, Range u, Range v,
                           const Visit& visit);

  DirectionCharts charts_of_{Origin{}, {}};
  std::vector<Chart> charts_;
  std::vector<std::uint32_t> at_origin_;
};

inline bool DirectionIndex::Entry::reaches(const List& to) const {
  return lower[0] <= to.u && to.u <= upper[0] && lower[1] <= to.v && to.v <= upper[1] && !(to.depth < near);
}

}  // namespace strata

#include "extensions/scene/direction_index_visits.h"
