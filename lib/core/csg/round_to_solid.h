#pragma once
#include "core/mesh/nearest_mesh.h"
#include "strata/combine.h"
#include "strata/monitor.h"
#include "strata/rounding.h"

namespace strata {

/// Rounds the mesh of a result, to which `mesh` refers, to the grid of the options, on all threads of the caller's
/// arena. It stays where it is if nothing of it changes. Few exact positions are asked for.
void round_result(const NearestMesh& mesh, const Options& options, const Monitor& monitor, BooleanResult& result);

/// Puts a rounded mesh in the place of the exact one that it was made from.
void put_rounded(RoundedMesh rounded, BooleanResult& result);

}  // namespace strata
