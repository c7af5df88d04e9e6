#pragma once

namespace strata {

/// Cosine and sine of an angle.
struct CosineSine {
  double cosine = 1;
  double sine = 0;
};

/// Of an angle in [0, 360) degrees, from those of angles up to 45: exact where they are 0, 1/2 or 1, the nearest
/// doubles to the square roots of 1/2 and 3/4, and equal up to signs wherever symmetry says so.
[[nodiscard]] CosineSine cosine_sine(double degrees);

}  // namespace strata
