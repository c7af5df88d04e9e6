#include "core/exact/arithmetic.h"

#include <catch2/catch.hpp>
#include <cfenv>
#include <stdexcept>
#include <string>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

using namespace strata;

namespace {

/// What is said, if anything, while `change` holds.
template <class Change, class Back>
std::string said(const Change& change, const Back& back) {
  std::string text;
  change();
  try {
    ensure_ieee_arithmetic();
  } catch (const std::runtime_error& error) {
    text = error.what();
  }
  back();
  return text;
}

}  // namespace

TEST_CASE("arithmetic that does not round to nearest is refused", "[exact]") {
  ensure_ieee_arithmetic();
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    CHECK(said([&] { std::fesetround(mode); }, [] { std::fesetround(FE_TONEAREST); }).find("fesetround") !=
          std::string::npos);
  ensure_ieee_arithmetic();
}

#if defined(__SSE2__)
TEST_CASE("arithmetic without subnormal numbers is refused", "[exact]") {
  const unsigned before = _mm_getcsr();
  constexpr unsigned results_are_zero = 0x8000, operands_are_zero = 0x0040;
  for (const unsigned flags : {results_are_zero, operands_are_zero, results_are_zero | operands_are_zero})
    CHECK(said([&] { _mm_setcsr(before | flags); }, [&] { _mm_setcsr(before); }).find("-ffast-math") !=
          std::string::npos);
  ensure_ieee_arithmetic();
}
#endif
