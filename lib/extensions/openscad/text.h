#pragma once
#include "extensions/openscad/fonts.h"
#include "extensions/openscad/part.h"
#include "extensions/openscad/report.h"
#include "extensions/openscad/syntax.h"

namespace strata::openscad {

/// The glyphs of a text, united: what their outlines wind around. Curves have an eighth of the sides of a circle whose
/// radius is the size, and one more, at least 2. Nothing, with a note, for a text without ink and for a size that is 0
/// or not finite. Throws CsgError for arguments of wrong kinds, for what is no UTF-8, for numbers that are too large,
/// where there is no font, and where this build reads none.
[[nodiscard]] Part text(const SyntaxNode& node, Fonts& fonts, Report& report);

}  // namespace strata::openscad
