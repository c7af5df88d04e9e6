#pragma once
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "extensions/convex/cell.h"
#include "strata/convex.h"
#include "strata/mesh.h"

namespace strata::convex {

;

/// Collects corners and computes their positions at the end: coincident corners are one point.
class PointList {
 public:
  PointList(const HyperplaneTable<3>& table, CellMaker& maker) : table_(table), maker_(maker) {}

  /// A number for a corner; coincident corners may have several.
  [[nodiscard]] std::uint32_t number_of(std::uint32_t corner);

  /// All points in lexicographic order of their exact positions, as nearest doubles and, where these are not exact, by
  /// their planes. Returns the point of each number. O(n log n); positions are computed on all threads.
  [[nodiscard]] std::vector<std::uint32_t> sorted(std::vector<Vertex>& points, std::vector<MeetOfThree>& meets) const;

 private:
  const HyperplaneTable<3>& table_;
  CellMaker& maker_;
  std::vector<std::uint32_t> corners_;  ///< by number
  std::unordered_map<std::uint32_t, std::uint32_t> of_corner_;
};

}  // namespace strata::convex
