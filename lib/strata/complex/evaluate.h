#pragma once
#include <functional>
#include <span>

#include "strata/complex/selective_complex.h"
#include "strata/csg/expression.h"

namespace strata::complex {

/// An expression about complexes: its solids stand for them, one per primitive and in that order. Not regularized, in
/// one overlay of all. Throws as `combine` does.
[[nodiscard]] SelectiveComplex evaluate(const Expression& expression, std::span<const SelectiveComplex> primitives,
                                        const Monitor& monitor = {});

/// True when a point is in the set that a disjunctive form of complexes stands for. A complex is asked at most once.
[[nodiscard]] bool contains(const Expression::Products& products, std::span<const SelectiveComplex> primitives,
                            const Vertex& p);

}  // namespace strata::complex
