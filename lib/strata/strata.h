#pragma once
/// Strata: exact Booleans of solids given as triangle meshes.
#include "strata/csg/check.h"
#include "strata/csg/combine.h"
#include "strata/csg/options.h"
#include "strata/csg/solid.h"
#include "strata/mesh/canonical.h"
#include "strata/mesh/defect.h"
#include "strata/mesh/measure.h"
#include "strata/mesh/mesh.h"
