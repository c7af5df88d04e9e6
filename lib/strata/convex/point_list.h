#pragma once
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "strata/convex/cell.h"
#include "strata/mesh/exact_mesh.h"

namespace strata::convex {

/// Numbers corners by their exact places: corners at one place have one number.
class PointList {
 public:
  PointList(const HyperplaneTable<3>& table, CellMaker& maker) : table_(table), maker_(maker) {}

  [[nodiscard]] std::uint32_t number_of(std::uint32_t corner);

  /// All points in lexicographic order of their places, as doubles and, where these are not exact, rationals. Returns
  /// the new number of each. O(n log n).
  [[nodiscard]] std::vector<std::uint32_t> sorted(std::vector<Vertex>& points, std::vector<ExactVertex>& exact) const;

 private:
  struct Place {
    Vertex nearest{};
    std::optional<RationalPoint> exact;  ///< where these doubles are not exact
  };
  static Place place_of(const RationalPoint& p);
  static bool is_before(const Place& a, const Place& b);
  [[nodiscard]] static bool is_same(const Place& a, const Place& b);

  const HyperplaneTable<3>& table_;
  CellMaker& maker_;
  std::vector<Place> places_;
  std::unordered_map<std::uint32_t, std::uint32_t> of_corner_;
  std::unordered_multimap<std::size_t, std::uint32_t> of_hash_;  ///< of nearest doubles
};

}  // namespace strata::convex
