#pragma once
#include <string>

#include "strata/mesh.h"

namespace verify {

/// A small picture of any mesh, closed or not, as an SVG element: faces that look at the viewer, back to front by their
/// middles, and edges where the surface bends. For a look at a case, not for proof: `strata draw` decides exactly what
/// is seen. Meshes of hundreds of triangles are told by a number instead. Needs the style sheet.
[[nodiscard]] std::string sketch(const strata::Mesh& mesh);

/// Style sheet rules for sketches.
[[nodiscard]] std::string sketch_style();

}  // namespace verify
