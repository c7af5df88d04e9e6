#pragma once
#include <array>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <span>
#include <vector>

#include "core/kernel/hyperplane_table.h"

namespace strata::bsp {

/// A convex part of a hyperplane, of the hyperplane's own dimension: a point of the line, a segment, a convex polygon.
/// Where it is unbounded it extends to the frame (`HyperplaneMeet`).
///
/// In the plane it is directed from its first corner to its second one, with the plus side on the left. In space its
/// corners are listed counter-clockwise as seen from the plus side, and `walls[i]` is the other plane through corners i
/// and i + 1.
template <int D>
struct Piece {
  static constexpr std::size_t usual = D == 3 ? 6 : D;

  std::uint32_t hyperplane = 0;
  boost::container::small_vector<HyperplaneMeet<D>, usual> corners;
  boost::container::small_vector<std::uint32_t, usual> walls;  ///< empty unless D = 3

  [[nodiscard]] bool is_bounded() const {
    for (const HyperplaneMeet<D>& c : corners)
      if (c.is_far) return false;
    return true;
  }
};

/// One side of a hyperplane.
struct HalfSpace {
  std::uint32_t hyperplane = 0;
  Sign side = Sign::positive;  ///< positive or negative
};

/// The half-spaces whose intersection is the part of space that a node of a tree divides, from the root on.
using Path = std::vector<HalfSpace>;

/// The position of a piece relative to a hyperplane.
enum class Lie { minus, plus, both, on };

/// The position of a piece with corners on the minus side, on the plus side, on both, or on the hyperplane only.
[[nodiscard]] constexpr Lie lie_of(bool has_minus, bool has_plus) {
  if (has_minus && has_plus) return Lie::both;
  return has_minus ? Lie::minus : has_plus ? Lie::plus : Lie::on;
}

/// A piece and its parts: `minus` and `plus` are set if the piece lies on both sides, otherwise empty.
template <int D>
struct Split {
  Lie lie = Lie::on;
  Piece<D> minus, plus;
};

/// The whole hyperplane, up to the frame.
template <int D>
[[nodiscard]] Piece<D> whole(const HyperplaneTable<D>& table, std::uint32_t hyperplane);
template <>
Piece<1> whole(const HyperplaneTable<1>& table, std::uint32_t hyperplane);
template <>
Piece<2> whole(const HyperplaneTable<2>& table, std::uint32_t hyperplane);
template <>
Piece<3> whole(const HyperplaneTable<3>& table, std::uint32_t hyperplane);

/// A side of the frame: the part of x_axis = W or -W between the others. Every unbounded region reaches such a side.
template <int D>
[[nodiscard]] Piece<D> side_of_frame(const HyperplaneTable<D>& table, std::size_t axis, bool is_upper);
template <>
Piece<1> side_of_frame(const HyperplaneTable<1>& table, std::size_t axis, bool is_upper);
template <>
Piece<2> side_of_frame(const HyperplaneTable<2>& table, std::size_t axis, bool is_upper);
template <>
Piece<3> side_of_frame(const HyperplaneTable<3>& table, std::size_t axis, bool is_upper);

/// Two planes of space for each axis, the lower one first, both with normals towards larger coordinates.
using BoxPlanes = std::array<std::array<std::uint32_t, 2>, 3>;

/// The part of a plane between the planes of a box along the two axes that are farther from its normal, or the same for
/// a side of the box itself. It may extend beyond the box along the third axis.
[[nodiscard]] Piece<3> whole_between(const HyperplaneTable<3>& table, std::uint32_t plane, const BoxPlanes& box);

/// The sides of a hyperplane on which a piece lies; it may touch it.
template <int D>
[[nodiscard]] Lie lie_of(const HyperplaneTable<D>& table, const Piece<D>& piece, std::uint32_t hyperplane);

/// The approximate position of a piece, by rounded doubles: corners that are nearly in the hyperplane count as in it.
/// For estimates of cost; decides nothing.
template <int D>
[[nodiscard]] Lie estimated_lie(const HyperplaneTable<D>& table, const Piece<D>& piece, std::uint32_t hyperplane);

/// Divides a piece by a hyperplane. O(corners).
template <int D>
[[nodiscard]] Split<D> split(const HyperplaneTable<D>& table, const Piece<D>& piece, std::uint32_t hyperplane);

/// Keeps the part in a half-space. False when no part of the piece's own dimension is left; then it is unchanged.
template <int D>
[[nodiscard]] bool clip(const HyperplaneTable<D>& table, Piece<D>& piece, HalfSpace half_space);

/// The part of a hyperplane in the intersection of half-spaces. The last ones are applied first: they cut off most.
/// Requires that the part is not empty.
template <int D>
[[nodiscard]] Piece<D> part_within(const HyperplaneTable<D>& table, std::uint32_t hyperplane,
                                   std::span<const HalfSpace> path);

}  // namespace strata::bsp
