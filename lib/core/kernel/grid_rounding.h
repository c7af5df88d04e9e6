#pragma once
#include "strata/coordinate_grid.h"
#include "strata/mesh.h"

namespace strata {

/// Rounds doubles to a grid. Monotone in each coordinate, and numbers of the grid stay: vertices in one place stay in
/// one place.
class GridRounding {
 public:
  /// Throws std::invalid_argument for a step that is negative or no quotient of two integers that are doubles.
  explicit GridRounding(const CoordinateGrid& grid);

  /// The number of the grid nearest to x. Infinite where the format has none.
  [[nodiscard]] double operator()(double x) const;
  /// The same with some bits less: of the significand, or with a step that many times doubled. 0 if none are left.
  [[nodiscard]] double operator()(double x, int bits_less) const;
  [[nodiscard]] Vertex operator()(const Vertex& v, int bits_less) const;
  [[nodiscard]] bool holds(const Vertex& v) const;
  [[nodiscard]] bool holds_all_doubles() const { return format_ == CoordinateGrid::Format::float64 && numerator_ == 0; }

  /// The distance from a number of this size to the next.
  [[nodiscard]] double unit_at(double x) const;
  /// Numbers have no more bits than that.
  static constexpr int most_bits = 64;

 private:
  [[nodiscard]] double to_format(double x) const;

  CoordinateGrid::Format format_;
  double numerator_ = 0, denominator_ = 1;  ///< of the step; 0: none
};

}  // namespace strata
