#pragma once
#include <string>

#include "extensions/openscad/part.h"
#include "extensions/openscad/report.h"
#include "extensions/openscad/syntax.h"
#include "strata/openscad.h"

namespace strata::openscad {

/// The solid beneath a field of heights, which a PNG file draws (picture.h), whatever its name, or a text file lists:
/// rows of numbers, one unit apart, the first row at y = 0. Shorter rows end with zeros; lines that begin with # are
/// skipped. Between four heights are four triangles around their mean; the base lies one unit beneath the least height,
/// and not above 0. Nothing, with a note, for less than two rows or columns. `name` is for the solid. Throws CsgError
/// for files that are not read, with the place in them.
[[nodiscard]] Part surface(const SyntaxNode& node, const std::string& name, const CsgOptions& options, Report& report);

}  // namespace strata::openscad
