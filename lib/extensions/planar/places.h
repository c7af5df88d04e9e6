#pragma once
#include <cstddef>
#include <cstdint>

#include "core/exact/bounded.h"
#include "core/kernel/filtered_orientation.h"
#include "strata/planar.h"

namespace strata::planar {

/// A coordinate of a point with a bound on its rounding error.
[[nodiscard]] inline Bounded bounded(const Places& places, std::uint32_t p, std::size_t axis) {
  return places.is_double(p) ? Bounded(places.place[p][axis])
                             : Bounded(places.place[p][axis], places.error[p - places.doubles()][axis]);
}

}  // namespace strata::planar
