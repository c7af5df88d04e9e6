#pragma once
#include <array>
#include <string>
#include <vector>

#include "palette.h"

/// Convex cells as polygons, seen counter-clockwise from outside.
using CellPolygons = std::vector<std::vector<std::array<double, 3>>>;

/// How far cells move away from the middle, relative to where they are.
inline constexpr double exploded = 0.35, in_place = 0;

/// Writes cells, coloured in turn and pulled apart from the middle of all of them, as glTF 2.0 (.glb). In units of
/// their common size, since glTF has floats only. Throws strata::IoError.
void write_cells(const std::string& path, const std::vector<CellPolygons>& cells, double distance);

/// The same in colours of one's own, one per polygon.
void write_cells(const std::string& path, const std::vector<CellPolygons>& cells,
                 const std::vector<std::vector<Colour>>& colours, double distance);
