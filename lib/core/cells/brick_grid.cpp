#include "core/cells/brick_grid.h"

#include <algorithm>
#include <limits>

namespace strata {
namespace {

/// The shift at which the whole grid is one brick.
constexpr int coarsest = 31;

}  // namespace

BrickGrid::BrickGrid(const Space& space, std::size_t budget, std::int32_t least_side)
    : grid_(space.grid), corner_(space.corner) {
  const GridBox& interest = space.interest;
  const auto fits = [&](int shift) {
    std::size_t bricks = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto along = static_cast<std::size_t>(((interest.upper[i] - 1 - interest.lower[i]) >> shift) + 1);
      if (along > most_per_axis) return false;
      bricks *= along;
    }
    return bricks <= budget;
  };
  int shift = coarsest;
  while (shift > 0 && fits(shift - 1) && std::int64_t{1} << (shift - 1) >= least_side) --shift;
  divide(interest, shift);
  while (shift_ < coarsest && !has_centres()) divide(interest, shift_ + 1);
}

void BrickGrid::divide(const GridBox& interest, int shift) {
  shift_ = shift;
  lower_ = interest.lower;
  upper_ = interest.upper;
  for (std::size_t i = 0; i < 3; ++i)
    size_[i] = static_cast<std::uint32_t>((interest.upper[i] - 1 - interest.lower[i]) >> shift) + 3;
  stride_ = {1, size_[0], size_[0] * size_[1]};
}

GridBox BrickGrid::box(BrickCode code) const {
  GridBox r;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t low =
        lower_[at(axis)] + (static_cast<std::int64_t>(BrickBox::along(code, axis)) - 1) * (std::int64_t{1} << shift_);
    r.lower[at(axis)] = static_cast<std::int32_t>(low);
    r.upper[at(axis)] =
        static_cast<std::int32_t>(std::min(low + (std::int64_t{1} << shift_), std::int64_t{upper_[at(axis)]}));
  }
  return r;
}

double BrickGrid::centre(int axis, std::uint32_t k) const {
  const GridBox b = box(k << (8 * axis));
  // Not the middle: inputs are often symmetric, and an origin in a face's plane costs an exact evaluation.
  const double low = b.lower[at(axis)], side = static_cast<double>(b.upper[at(axis)]) - low;
  const double middle = grid_.inverse(axis, static_cast<std::int32_t>(low + side * 0.4638));
  // The corner itself, if doubles have no other point.
  return k == 1 && along(axis, grid_.at(axis, middle)) != k ? corner_[at(axis)] : middle;
}

InputComplex::Coordinates BrickGrid::centre(BrickCode code) const {
  return {centre(0, BrickBox::along(code, 0)), centre(1, BrickBox::along(code, 1)),
          centre(2, BrickBox::along(code, 2))};
}

bool BrickGrid::has_centres() const {
  for (int axis = 0; axis < 3; ++axis)
    for (std::uint32_t k = 1; k + 1 < size(axis); ++k)
      if (along(axis, grid_.at(axis, centre(axis, k))) != k) return false;
  return true;
}

double BrickGrid::lower_bound(int axis, std::uint32_t k) const {
  // Binary search over doubles in the order of integers: the map to bricks is monotone.
  const auto ordered = [](double x) {
    const auto i = std::bit_cast<std::int64_t>(x);
    return i < 0 ? std::numeric_limits<std::int64_t>::min() - i : i;
  };
  const auto value = [](std::int64_t i) {
    return std::bit_cast<double>(i < 0 ? std::numeric_limits<std::int64_t>::min() - i : i);
  };
  const auto is_below = [&](std::int64_t i) { return along(axis, grid_.at(axis, value(i))) < k; };
  std::int64_t low = ordered(-std::numeric_limits<double>::max()), high = ordered(std::numeric_limits<double>::max());
  if (!is_below(low)) return value(low);
  // The bound is usually near the value of the grid's inverse.
  constexpr std::int64_t far = 64;
  const std::int64_t start = lower_[at(axis)] + (std::int64_t{k - 1} << shift_);
  const double inverse =
      grid_.inverse(axis, static_cast<std::int32_t>(std::min<std::int64_t>(start, upper_[at(axis)])));
  const std::int64_t guess = std::clamp(ordered(inverse), low + far, high - far);
  if (is_below(guess - far) && !is_below(guess + far)) {
    low = guess - far;
    high = guess + far;
  }
  while (low < high) {
    const std::int64_t middle = (low >> 1) + (high >> 1) + (low & high & 1);
    if (is_below(middle)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return value(low);
}

}  // namespace strata
