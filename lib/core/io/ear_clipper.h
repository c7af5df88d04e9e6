#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/exact/sign.h"
#include "core/kernel/predicates.h"
#include "strata/mesh.h"

namespace strata::io {

/// Triangulates a counter-clockwise polygon by cutting ears. An ear is a strictly convex corner v with neighbours u and
/// w such that no other vertex lies in the closed triangle uvw, except vertices at the positions of u, v and w. A
/// polygon that is simple, or meets itself in corners and along whole sides only, always has one. Only corners that are
/// not convex can prevent an ear, so these are stored in a grid.
class EarClipper {
 public:
  explicit EarClipper(std::span<const PlanePoint> points);

  /// Writes n - 2 triangles. False when the polygon was found not to be simple.
  bool clip(std::span<Triangle> triangles);

 private:
  static constexpr std::uint32_t none = 0xffff'ffff;

  void build_grid();
  [[nodiscard]] std::uint32_t cell(double x, std::size_t axis) const;
  [[nodiscard]] bool is_ear(std::uint32_t corner);
  [[nodiscard]] bool is_in_the_way(std::uint32_t candidate, std::uint32_t corner) const;
  [[nodiscard]] std::uint32_t find_obstacle(std::uint32_t corner) const;
  [[nodiscard]] Sign orientation_at(std::uint32_t corner) const;
  void cut(std::uint32_t corner, Triangle& triangle);
  std::uint32_t flat_corner(std::uint32_t start) const;

  std::span<const PlanePoint> points_;
  std::vector<std::uint32_t> previous_, next_;
  std::vector<Sign> shape_;              ///< positive: convex; zero: straight or a spike
  std::vector<std::uint32_t> obstacle_;  ///< a vertex known to be in the triangle of this corner
  std::vector<bool> cut_;
  std::uint32_t remaining_ = 0;

  PlanePoint lower_{}, scale_{};  ///< of the grid
  std::uint32_t side_ = 1;        ///< cells per side
  std::vector<std::uint32_t> first_, in_cell_;
};

}  // namespace strata::io
