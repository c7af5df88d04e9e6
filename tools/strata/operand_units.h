#pragma once
#include <vector>

#include "files.h"
#include "settings.h"
#include "strata/unit.h"

/// The unit that --unit names; none without. Throws UsageError.
[[nodiscard]] strata::Unit unit_in(const Settings& settings);

/// Multiplies coordinates by a ratio of units, exactly: where the product is no double, the vertex becomes rational.
void convert(LoadedMesh& mesh, strata::Unit to);

/// Gives operands without a unit that of --unit, or that of the others, and converts all to that of the first one that
/// has any. Says so on stderr unless quiet. Without units nothing happens.
void use_one_unit(std::vector<LoadedMesh>& operands, const Settings& settings);

/// The objects of a mesh, each one mesh with its attributes, named after the file and the object; the mesh itself if it
/// has none.
[[nodiscard]] std::vector<LoadedMesh> objects_of(LoadedMesh mesh);
