#pragma once
#include <array>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "extensions/bsp/piece.h"

namespace strata::convex {

/// A facet of a cell, in a plane of a table.
struct CellFacet {
  std::uint32_t plane = 0;
  bool faces_plus = false;                                   ///< the outer side is the plus side
  boost::container::small_vector<std::uint32_t, 6> corners;  ///< counter-clockwise as seen from outside
  boost::container::small_vector<std::uint32_t, 6> walls;    ///< walls[i]: the other plane at the side from corner i
};

/// A convex cell of space: one facet per plane, every corner a vertex.
struct Cell {
  std::vector<CellFacet> facets;

  [[nodiscard]] const CellFacet* facet_in(std::uint32_t plane) const;
};

/// Constructs cells within a box and stores their corners, each once where cells were constructed by dividing one
/// another. All decisions are exact signs of the table. The table must outlive it.
class CellMaker {
 public:
  CellMaker(const HyperplaneTable<3>& table, const bsp::BoxPlanes& box) : table_(table), box_(box) {}

  [[nodiscard]] const HyperplaneMeet<3>& corner(std::uint32_t number) const { return corners_[number]; }

  /// The whole box.
  [[nodiscard]] Cell box();
  /// A polygon in a plane that contains all of the plane's part of the box.
  [[nodiscard]] bsp::Piece<3> whole(std::uint32_t plane) const { return bsp::whole_between(table_, plane, box_); }
  [[nodiscard]] bool is_of_box(std::uint32_t plane) const;

  /// Converts a polygon to a facet, and back.
  [[nodiscard]] CellFacet facet_of(const bsp::Piece<3>& polygon, bool faces_plus);
  [[nodiscard]] bsp::Piece<3> piece_of(const CellFacet& facet) const;

  struct Halves {
    std::optional<Cell> minus, plus;  ///< at least one is present
  };
  /// The parts on both sides of a plane, those with an interior. O(size of the cell + k^2) for a section
  /// of k sides.
  [[nodiscard]] Halves split(const Cell& cell, std::uint32_t plane);

  /// The union of two cells with disjoint interiors, on different sides of a plane, if it is convex. It is convex
  /// exactly if both have the same facet in this plane and no angle beside it is more than 180 degrees. O(size).
  [[nodiscard]] std::optional<Cell> merged(const Cell& a, const Cell& b, std::uint32_t plane);

  /// True when two corners coincide.
  [[nodiscard]] bool is_same(std::uint32_t a, std::uint32_t b);
  /// One of those that have been found to coincide with a corner.
  [[nodiscard]] std::uint32_t representative(std::uint32_t corner);

  /// True when boxes about two facets are disjoint; false if this is not known.
  [[nodiscard]] bool are_boxes_apart(const CellFacet& f, const CellFacet& g) const;

 private:
  class Splitter;
  class Merger;

  struct NamesHash {
    std::size_t operator()(const std::array<std::uint32_t, 3>& names) const;
  };
  /// The number of a corner; the same for all that have the same three names.
  std::uint32_t add(HyperplaneMeet<3> corner);

  const HyperplaneTable<3>& table_;
  bsp::BoxPlanes box_;
  std::vector<HyperplaneMeet<3>> corners_;
  std::unordered_map<std::array<std::uint32_t, 3>, std::uint32_t, NamesHash> numbers_;  ///< by names, increasing
  std::vector<std::pair<std::uint32_t, Sign>>
      signs_;                           ///< of corners, and the number of the division in which it was computed
  std::uint32_t split_ = 0;             ///< the number of the last division
  std::vector<std::uint32_t> same_as_;  ///< corners found to coincide, as a forest
};

}  // namespace strata::convex
