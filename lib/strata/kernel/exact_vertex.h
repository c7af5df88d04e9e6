#pragma once
#include <cstdint>

#include "strata/exact/rational.h"

namespace strata {

/// The exact place of one vertex whose coordinates are not three doubles.
struct ExactVertex {
  std::uint32_t vertex = 0;
  RationalPoint position;
};

}  // namespace strata
