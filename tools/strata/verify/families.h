#pragma once
#include "json_place.h"
#include "strata/mesh.h"

/// The generator families of cases, each from the line with its parameters. All meshes are closed and outward.
namespace verify {

[[nodiscard]] strata::Mesh make_box(const JsonPlace& line);    ///< {lower, upper}
[[nodiscard]] strata::Mesh make_boxes(const JsonPlace& line);  ///< {boxes: [[6 numbers], ...]}, nothing welded
[[nodiscard]] strata::Mesh make_grid(const JsonPlace& line);   ///< {count, lower, pitch, size}: separate boxes
[[nodiscard]] strata::Mesh make_cells(
    const JsonPlace& line);  ///< {count, pattern, lower, size}: union of lattice cells

[[nodiscard]] strata::Mesh make_tetrahedron(const JsonPlace& line);  ///< {corners: [[3 numbers] x 4]}, any order
[[nodiscard]] strata::Mesh make_octahedron(const JsonPlace& line);   ///< {centre, radius}
[[nodiscard]] strata::Mesh make_sphere(const JsonPlace& line);       ///< {centre, radius, level, noise, seed, float}
[[nodiscard]] strata::Mesh make_prism(const JsonPlace& line);        ///< {sides, radius, centre, bottom, top}

}  // namespace verify
