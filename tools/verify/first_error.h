#pragma once
#include <string>

#include "strata/mesh.h"

namespace verify {

/// The first error that the complete check finds, on one thread: faces that cross or coincide, shells the wrong way
/// round. Empty if there is none.
[[nodiscard]] std::string first_error(const strata::ExactMesh& mesh);

}  // namespace verify
