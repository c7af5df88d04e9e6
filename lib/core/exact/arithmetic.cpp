#include "core/exact/arithmetic.h"

#include <cfloat>
#include <limits>
#include <stdexcept>

#if defined(__FAST_MATH__)
#error "Strata needs IEEE arithmetic as it is written: compile it without -ffast-math"
#endif
#if FLT_EVAL_METHOD != 0
#error \
    "Strata needs doubles that are rounded after every operation: compile it for SSE2 (-msse2 -mfpmath=sse), not for the x87"
#endif

namespace strata {

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);

void ensure_ieee_arithmetic() {
  // What the compiler could compute beforehand would say nothing.
  const volatile double one = 1, tiny = 0x1p-60, smallest_normal = 0x1p-1022, smallest = 0x1p-1074, half = 0.5;
  if (one + tiny != one || one - tiny != one || -one - tiny != -one)
    throw std::runtime_error(
        "the floating-point arithmetic of this thread does not round to nearest (fesetround): results would not be "
        "exact");
  if (smallest_normal * half == 0 || smallest * one == 0)
    throw std::runtime_error(
        "the floating-point arithmetic of this thread takes subnormal numbers for zero, as in programs that are linked "
        "with "
        "-ffast-math: results would not be exact");
}

}  // namespace strata
