#pragma once
#include <utility>
#include <vector>

#include "strata/rational.h"

namespace strata::contact {

/// Closed intervals of a line, by a parameter.
using Interval = std::pair<Rational, Rational>;
using Intervals = std::vector<Interval>;

/// Maximal intervals of positive length of the closure of (union of `all` without union of `taken`), in order. Where
/// nothing is taken, intervals that share an end are joined. O(n log n).
[[nodiscard]] Intervals without(const Intervals& all, const Intervals& taken);

}  // namespace strata::contact
