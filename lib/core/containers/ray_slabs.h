#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/kernel/box.h"
#include "strata/mesh.h"

namespace strata {

/// Two boxes, tested together: [lower or upper][axis][box].
using BoxPair = std::array<std::array<std::array<double, 2>, 3>, 2>;

/// The parameters at which a line enters two boxes, and whether it meets them.
struct BoxEntries {
  std::array<double, 2> near;
  std::array<bool, 2> met;
};

/// The slab test in doubles, which never misses: a box that a line meets at a parameter of [0, limit] is reported, and
/// `near` exceeds that parameter by at most a relative 2^-50. Nearby boxes may be reported too.
///
/// Per axis the line is between the slab's planes for t in [(l - o) / d, (u - o) / d], of which the test computes
/// fl(fl(l - o) * fl(1 / d)): a relative error of at most (1 + u)^4 - 1 (d itself may be rounded once), u = 2^-53, and
/// 2^-1074 where the product underflows. With near >= 0 and far >= 0 the widening of far covers both ends' errors. It
/// makes far infinite wherever near overflows although the line meets the box.
/// - d = 0: the inverse is +infinity; (l - o) * infinity is -infinity, or NaN if l = o, +infinity if the line is
///   outside. NaN loses every comparison, so that this end of the slab says nothing: right, for the box is closed.
/// - An axis where 1 / d or a difference may leave the normal numbers gets the inverse NaN, and says nothing at all.
class RaySlabs {
 public:
  /// `direction` may be rounded to nearest. Boxes must be within `all`.
  RaySlabs(const Vertex& from, const Vertex& direction, const Box& all) : from_(from) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double d = std::abs(direction[i]);
      const bool is_tame = (d == 0 || (d >= 0x1p-1022 && d <= 0x1p1022)) && std::isfinite(all.lower[i] - from[i]) &&
                           std::isfinite(all.upper[i] - from[i]);
      inverse_[i] = !is_tame ? std::numeric_limits<double>::quiet_NaN() : d == 0 ? HUGE_VAL : 1 / direction[i];
      near_side_[i] = direction[i] < 0 ? 1 : 0;
    }
  }

  [[nodiscard]] BoxEntries enter(const BoxPair& boxes, double limit) const {
    BoxEntries e;
    std::array<double, 2> far{limit, limit};
    e.near = {0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &first = boxes[near_side_[i]][i], &last = boxes[1 - near_side_[i]][i];
      for (std::size_t k = 0; k < 2; ++k) {  // both keep what they have against NaN
        e.near[k] = std::max(e.near[k], (first[k] - from_[i]) * inverse_[i]);
        far[k] = std::min(far[k], (last[k] - from_[i]) * inverse_[i]);
      }
    }
    for (std::size_t k = 0; k < 2; ++k) e.met[k] = e.near[k] <= far[k] * (1 + 0x1p-49) + 0x1p-1060;
    return e;
  }

 private:
  Vertex from_, inverse_{};
  std::array<std::size_t, 3> near_side_{};
};

}  // namespace strata
