#pragma once
#include <array>
#include <cmath>
#include <vector>

#include "core/cells/brick_grid.h"

namespace strata {

/// Bounds of the bricks in space: brick k along an axis contains only points between bounds k and k + 1.
class BrickBounds {
 public:
  explicit BrickBounds(const BrickGrid& bricks);

  [[nodiscard]] double lower(int axis, std::uint32_t k) const { return bounds_[static_cast<std::size_t>(axis)][k]; }
  [[nodiscard]] double upper(int axis, std::uint32_t k) const { return lower(axis, k + 1); }

 private:
  std::array<std::vector<double>, 3> bounds_;
};

/// Decides in which bricks the plane of a face may be, by doubles with a bound on all errors. It never misses one.
class PlaneFilter {
 public:
  PlaneFilter(const InputComplex::Coordinates& a, const InputComplex::Coordinates& b,
              const InputComplex::Coordinates& c);

  static constexpr double slack = 0x1p-47;  ///< for errors, in units of the sizes of terms

  /// May the plane meet the box? A box inside one that is rejected with eight times the slack is rejected.
  [[nodiscard]] bool meets(const InputComplex::Coordinates& lower, const InputComplex::Coordinates& upper,
                           double error = slack) const {
    double value = 0, reach = 0, size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double middle = (lower[i] * 0.5 + upper[i] * 0.5) - a_[i], half = upper[i] * 0.5 - lower[i] * 0.5;
      value += n_[i] * middle;
      reach += std::abs(n_[i]) * half;
      size += scale_[i] * (std::abs(middle) + half + std::abs(lower[i]) + std::abs(upper[i]));
    }
    return !(std::abs(value) > reach + size * error + 0x1p-900);  // true when anything is not a number
  }

 private:
  InputComplex::Coordinates a_, n_{}, scale_{};
};

/// Lists the bricks of faces: all bricks of a face's box, or, where these are many, those that its plane may meet. So
/// every brick that contains a point of a face is listed.
class Raster {
 public:
  Raster(const InputComplex& input, const BrickGrid& bricks);

  /// True when a face that spans `box` is not listed in all of its bricks.
  [[nodiscard]] bool thins(const BrickBox& box) const { return is_exact_ && box.size() > few_bricks; }

  /// May the plane meet the brick?
  [[nodiscard]] bool meets(const PlaneFilter& plane, BrickCode brick) const {
    return meets(plane, {brick, brick}, PlaneFilter::slack);
  }

  /// Visits the bricks of a face that spans `box`.
  template <class Visit>
  void for_each_brick(const InputComplex::Coordinates& a, const InputComplex::Coordinates& b,
                      const InputComplex::Coordinates& c, const BrickBox& box, const Visit& visit) const {
    if (box.lower == box.upper) {
      visit(bricks_.index(box.lower));
    } else if (thins(box)) {
      divide(PlaneFilter(a, b, c), box, visit);
    } else {
      bricks_.for_each(box, visit);
    }
  }

 private:
  static constexpr std::uint32_t few_bricks = 8;

  [[nodiscard]] bool meets(const PlaneFilter& plane, const BrickBox& box, double error) const {
    InputComplex::Coordinates lower, upper;
    for (int axis = 0; axis < 3; ++axis) {
      lower[static_cast<std::size_t>(axis)] = bounds_.lower(axis, BrickBox::along(box.lower, axis));
      upper[static_cast<std::size_t>(axis)] = bounds_.upper(axis, BrickBox::along(box.upper, axis));
    }
    return plane.meets(lower, upper, error);
  }

  /// Halves the box along its longest side for as long as the plane may meet it.
  template <class Visit>
  void divide(const PlaneFilter& plane, const BrickBox& box, const Visit& visit) const {
    const bool is_one = box.lower == box.upper;
    if (!meets(plane, box, is_one ? PlaneFilter::slack : 8 * PlaneFilter::slack)) return;
    if (is_one) return visit(bricks_.index(box.lower));
    int longest = 0;
    std::uint32_t length = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const auto along = BrickBox::along(box.upper, axis) - BrickBox::along(box.lower, axis);
      if (along <= length) continue;
      longest = axis;
      length = along;
    }
    const std::uint32_t one = 1u << (8 * longest), middle = BrickBox::along(box.lower, longest) + length / 2;
    BrickBox first = box, second = box;
    first.upper = (box.upper & ~(0xffu << (8 * longest))) | middle << (8 * longest);
    second.lower = (box.lower & ~(0xffu << (8 * longest))) | ((middle << (8 * longest)) + one);
    divide(plane, first, visit);
    divide(plane, second, visit);
  }

  const BrickGrid& bricks_;
  BrickBounds bounds_;
  bool is_exact_;  ///< true when all vertices are doubles
};

}  // namespace strata
