#pragma once
#include "strata/rational.h"

namespace strata::contact {

/// The square root of a rational that is not negative, within an ulp; infinite beyond doubles. O(size of x).
[[nodiscard]] double root(const Rational& x);

}  // namespace strata::contact
