#pragma once
/// The numbers that rounded coordinates may be.
#include "strata/rational.h"

namespace strata {

/// Doubles, floats, or those of them that are nearest to multiples of a step.
struct CoordinateGrid {
  enum class Format { float64, float32 };
  Format format = Format::float64;
  /// If positive, coordinates are the numbers of the format nearest to multiples of it. It must be a quotient of two
  /// integers that are doubles, as 1/1000 and 3/200 are. Coordinates should be below 2^50 steps.
  Rational step = 0;
};

}  // namespace strata
