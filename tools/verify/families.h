#pragma once
#include "common/json_location.h"
#include "strata/mesh.h"

/// The generator families of cases, each from the line with its parameters. All meshes are closed and outward.
namespace verify {

[[nodiscard]] strata::Mesh make_box(const JsonLocation& line);    ///< {lower, upper}
[[nodiscard]] strata::Mesh make_boxes(const JsonLocation& line);  ///< {boxes: [[6 numbers], ...]}, nothing welded
[[nodiscard]] strata::Mesh make_grid(const JsonLocation& line);   ///< {count, lower, pitch, size}: separate boxes
[[nodiscard]] strata::Mesh make_cells(
    const JsonLocation& line);  ///< {count, pattern, lower, size}: union of lattice cells

[[nodiscard]] strata::Mesh make_tetrahedron(const JsonLocation& line);  ///< {corners: [[3 numbers] x 4]}, any order
[[nodiscard]] strata::Mesh make_octahedron(const JsonLocation& line);   ///< {centre, radius}
[[nodiscard]] strata::Mesh make_sphere(const JsonLocation& line);       ///< {centre, radius, level, noise, seed, float}
[[nodiscard]] strata::Mesh make_prism(const JsonLocation& line);        ///< {sides, radius, centre, bottom, top}

}  // namespace verify
