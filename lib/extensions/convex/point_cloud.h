#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/exact/bounded.h"
#include "core/exact/sign.h"
#include "core/kernel/homogeneous.h"
#include "strata/mesh.h"

namespace strata::convex {

/// Points of space by number, and all decisions about them: signs of exact expressions, for finite doubles of any
/// magnitude and for rationals. Refers to the given points. Reading is thread-safe.
class PointCloud {
 public:
  /// Throws std::invalid_argument for coordinates that are not finite, for exact positions that are not by increasing
  /// index or whose nearest doubles are not those of the mesh. O(n).
  explicit PointCloud(ExactMeshView points);

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(at_.size()); }
  /// The position in nearest doubles.
  [[nodiscard]] const Vertex& at(std::uint32_t p) const { return at_[p]; }
  /// The exact position where the nearest doubles differ from it, otherwise null. O(log of their number).
  [[nodiscard]] const RationalPoint* exact(std::uint32_t p) const;
  /// The coordinates with bounds on the rounding error.
  [[nodiscard]] std::array<Bounded, 3> bounded(std::uint32_t p) const;
  /// For every axis the largest difference of two coordinates, with a bound: no difference of points exceeds it.
  [[nodiscard]] const std::array<Bounded, 3>& extent() const { return extent_; }
  /// The lowest coordinates, in nearest doubles.
  [[nodiscard]] const Vertex& lowest() const { return lowest_; }
  /// True when doubles compute orient3d of any four points without rounding.
  [[nodiscard]] bool is_small_lattice() const { return small_lattice_; }

  /// Order of two points by x, then y, then z: negative when p is first, zero for equal positions.
  [[nodiscard]] Sign compare(std::uint32_t p, std::uint32_t q) const;
  /// The same by one coordinate.
  [[nodiscard]] Sign compare(std::uint32_t p, std::uint32_t q, std::size_t axis) const;
  /// Side of p of the plane through a, b, c: positive when p sees them counter-clockwise.
  [[nodiscard]] Sign side(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t p) const;
  /// Orientation of p, q, r as seen against an axis, in the axes after it: positive when counter-clockwise.
  [[nodiscard]] Sign orientation(std::uint32_t p, std::uint32_t q, std::uint32_t r, std::size_t axis) const;

 private:
  struct Rounded {
    std::uint32_t point;
    const RationalPoint* place;
    HPoint<Integer> homogeneous;
  };

  void read_exact(ExactMeshView points);
  void measure();
  [[nodiscard]] const Rounded* rounded(std::uint32_t p) const;
  template <class Int, std::size_t N>
  [[nodiscard]] std::array<HPoint<Int>, N> integers(const std::array<std::uint32_t, N>& points,
                                                    const Lattice& lattice) const;
  template <std::size_t N, class Value>
  [[nodiscard]] Sign decide(const std::array<std::uint32_t, N>& points, const Value& value) const;

  std::span<const Vertex> at_;
  std::vector<Rounded> rounded_;
  Vertex lowest_{};
  std::array<Bounded, 3> extent_{};
  bool small_lattice_ = false;
};

}  // namespace strata::convex
