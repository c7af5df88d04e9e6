#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/containers/box_tree.h"
#include "core/kernel/input_complex.h"
#include "core/winding/winding_oracle.h"

namespace strata {

/// Winding numbers about one operand, by rays in the direction of x: for few points of large meshes, where cells are
/// not worth making. Faces are listed in columns along x. O(n) to make, in parallel but for what is listed; O(faces in
/// the point's column) per point.
class RayWindings final : public WindingOracle {
 public:
  /// `asked`: faces that contain the points about which it will be asked; points elsewhere take O(n). Only columns of
  /// these faces are made. Requires one operand. The input must outlive it.
  RayWindings(const InputComplex& input, std::span<const std::uint32_t> asked);

  /// How many faces are compared with rays, one from each face asked about: an estimate.
  [[nodiscard]] std::size_t comparisons() const { return comparisons_; }

  [[nodiscard]] Windings around(const Point& q, std::uint32_t own) const override;
  [[nodiscard]] Windings above(std::uint32_t face, const Point& q,
                               std::span<const std::uint32_t> covering) const override;

 private:
  static constexpr std::uint32_t most_columns = 1024;  ///< in a row
  struct Cells {
    std::array<std::uint16_t, 2> lower, upper;
  };
  class FaceCells;
  [[nodiscard]] std::vector<std::uint32_t> choose_columns(std::span<const std::uint32_t> asked,
                                                          const FaceCells& cells_of_face);
  void list(std::span<const std::uint32_t> faces, const FaceCells& cells_of_face);
  [[nodiscard]] std::size_t estimate(std::span<const std::uint32_t> asked, const FaceCells& cells_of_face) const;
  [[nodiscard]] Cells cells_of(double low_y, double high_y, double low_z, double high_z) const;
  /// Of the box of a vertex.
  [[nodiscard]] Cells cells_of(std::uint32_t vertex) const;
  [[nodiscard]] static int column_count(const Cells& cells);
  /// Calls `visit(column)` for the columns of a face, unless they are many: then it returns false.
  template <class Visit>
  bool for_each_column(const Cells& cells, const Visit& visit) const;
  template <class Visit>
  void for_each_column_of(const Cells& cells, const Visit& visit) const;  ///< however many there are
  /// The sum over all faces that the ray from q crosses. Faces whose plane contains q count as not crossed.
  [[nodiscard]] std::int32_t crossings(const Point& q) const;

  const InputComplex& input_;
  std::uint32_t width_ = 1;
  std::array<double, 2> origin_{}, per_cell_{};
  std::size_t comparisons_ = 0;
  double wide_near_ray_ = 0;                  ///< how many faces in many columns have that of a ray, on average
  std::vector<char> is_made_;                 ///< per column
  std::vector<std::uint32_t> first_, faces_;  ///< faces of each column that is made
  BoxTree wide_;                              ///< those in many columns
};

}  // namespace strata
