#pragma once

namespace strata {

/// Throws std::runtime_error where doubles are not those that filters and exact steps rest on: where this thread rounds
/// other than to nearest (fesetround), or takes subnormal numbers for zero, which a program does that is linked with
/// -ffast-math. A few operations; every way into the engine begins with it.
void ensure_ieee_arithmetic();

}  // namespace strata
