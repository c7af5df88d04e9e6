#pragma once
/// Colours of screens, and the light that they stand for.
///
/// Materials hold light (attributes.h); files, pictures and people mostly name colours of the sRGB standard.

namespace strata {

/// The light, from 0 to 1, of a component of an sRGB colour from 0 to 1. Values outside are clamped; of NaN it is NaN.
/// Source: IEC 61966-2-1.
[[nodiscard]] double light_of_srgb(double component);

/// The component of the sRGB colour that shows this light. Law: the inverse of light_of_srgb, to rounding.
[[nodiscard]] double srgb_of_light(double light);

}  // namespace strata
