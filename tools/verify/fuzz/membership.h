#pragma once
#include <string>

#include "strata/mesh.h"
#include "verify/case.h"

namespace fuzz {

/// Compares the result of a case with its operands at points: middles of pairs of their vertices, always the same ones
/// for the same case. A point off all operands is in the result if the expression says so, and never on it. Asks
/// `Locator`, which knows nothing of arrangements. Returns a sentence about the first point that is somewhere else;
/// empty if there is none.
[[nodiscard]] std::string misplaced_point(const verify::Case& c, const strata::ExactMesh& result);

}  // namespace fuzz
