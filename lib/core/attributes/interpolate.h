#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/attributes/face_frame.h"
#include "strata/attributes.h"

namespace strata {

/// The values at the three corners of a face, of one element: a span of components each.
template <class T>
using CornerValues = std::array<std::span<const T>, 3>;

/// Writes the value of a channel at a place in a face: exact, rounded once to T, to nearest, ties to even. Of several
/// corners that have equal bits in a component, that; of what is not finite, double arithmetic over the corners whose
/// weights are not 0. O(1), rational where double-doubles do not decide. theory.md, "Rounding".
template <class T>
void interpolate(const FaceFrame::Place& place, Interpolation rule, const CornerValues<T>& values, std::span<T> out);

/// x / sqrt(square), correctly rounded. Requires square > 0.
template <class T>
[[nodiscard]] T quotient_by_root(const Rational& x, const Rational& square);

extern template void interpolate(const FaceFrame::Place&, Interpolation, const CornerValues<float>&, std::span<float>);
extern template void interpolate(const FaceFrame::Place&, Interpolation, const CornerValues<double>&,
                                 std::span<double>);
extern template void interpolate(const FaceFrame::Place&, Interpolation, const CornerValues<std::uint8_t>&,
                                 std::span<std::uint8_t>);
extern template void interpolate(const FaceFrame::Place&, Interpolation, const CornerValues<std::int32_t>&,
                                 std::span<std::int32_t>);
extern template float quotient_by_root<float>(const Rational&, const Rational&);
extern template double quotient_by_root<double>(const Rational&, const Rational&);

}  // namespace strata
