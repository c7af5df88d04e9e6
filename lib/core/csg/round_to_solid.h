#pragma once
#include "core/mesh/nearest_mesh.h"
#include "strata/combine.h"
#include "strata/monitor.h"
#include "strata/rounding.h"

namespace strata {

/// As the public function, on all threads of the caller's arena. Few exact positions are asked for.
[[nodiscard]] RoundedMesh round_to_solid(const NearestMesh& mesh, const CoordinateGrid& grid, const Monitor& monitor);

/// Rounds the mesh of a result, to which `mesh` refers. It stays where it is if nothing of it changes.
void round_result(const NearestMesh& mesh, const CoordinateGrid& grid, const Monitor& monitor, BooleanResult& result);

/// Puts a rounded mesh in the place of the exact one that it was made from.
void put_rounded(RoundedMesh rounded, BooleanResult& result);

}  // namespace strata
