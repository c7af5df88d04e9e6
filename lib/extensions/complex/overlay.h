#pragma once
#include <span>

#include "extensions/complex/soup.h"
#include "strata/options.h"

namespace strata::complex {

/// The overlay of complexes in space. Vertices may be any rationals whose nearest doubles are finite.
/// Throws Cancelled, std::length_error.
[[nodiscard]] Overlay overlay(std::span<const Soup> operands, const Monitor& monitor = {});

/// The overlay of complexes in the plane.
[[nodiscard]] Overlay overlay(std::span<const Drawing> operands, const Monitor& monitor = {});

}  // namespace strata::complex
