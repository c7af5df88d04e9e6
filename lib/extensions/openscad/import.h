#pragma once
#include <string>

#include "extensions/openscad/part.h"
#include "extensions/openscad/report.h"
#include "extensions/openscad/syntax.h"
#include "strata/openscad.h"

namespace strata::openscad {

/// What a file holds: a solid (STL, OFF, OBJ, PLY, 3MF, AMF) or a shape (SVG, DXF). A mesh that crosses itself is the
/// solid that its faces wind around; one whose faces do not fit is repaired as InputClass::repair says, with a note.
/// Nothing, with a note, for no file name. `name` is for the solid. Throws CsgError for files that are not read, and
/// for meshes that bound no solid even so.
[[nodiscard]] Part import(const SyntaxNode& node, const std::string& name, const CsgOptions& options, Report& report);

}  // namespace strata::openscad
