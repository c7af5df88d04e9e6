#pragma once
#include <string>
#include <vector>

#include "strata/combine.h"
#include "strata/mesh.h"

namespace strata::test {

/// Checks that every triangle of a result lies in the plane of the operand's face it is said to come from.
/// Empty when that holds; else one sentence about the first triangle where it does not. Exact.
[[nodiscard]] std::string wrong_sources(const ExactMesh& result, const std::vector<Source>& sources,
                                        const std::vector<Mesh>& operands);

}  // namespace strata::test
