#pragma once
#include "strata/complex.h"

namespace strata::complex {

/// True when three vertices are collinear. Exact; by running errors in doubles where these decide.
[[nodiscard]] bool are_collinear(const Cells& cells, std::uint32_t a, std::uint32_t b, std::uint32_t c);

}  // namespace strata::complex
