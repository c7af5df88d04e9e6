#pragma once
#include <string>
#include <vector>

#include "core/kernel/input_complex.h"

namespace strata {

/// What does not hold of the input of an evaluation; empty: nothing.
///
/// Of all faces: corners exist, are three, have finite coordinates, and are in the box that was given. Of a sample:
/// faces have positive area, vertices that were identified are at one place. O(n), and a few hundred exact decisions.
[[nodiscard]] std::vector<std::string> validate(const InputComplex& input);

}  // namespace strata
