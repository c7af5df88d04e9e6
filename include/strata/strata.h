#pragma once
/// Strata: exact Booleans of solids given as triangle meshes, and what is built on them. This header has the core;
/// every extension has a header of its own: bsp.h, complex.h, contact.h, convex.h, incremental.h, openscad.h, planar.h,
/// query.h, section.h, surface.h.
#include "strata/check.h"
#include "strata/combine.h"
#include "strata/errors.h"
#include "strata/expression.h"
#include "strata/file_path.h"
#include "strata/formula.h"
#include "strata/function.h"
#include "strata/io.h"
#include "strata/measure.h"
#include "strata/mesh.h"
#include "strata/monitor.h"
#include "strata/options.h"
#include "strata/plane.h"
#include "strata/primitives.h"
#include "strata/rational.h"
#include "strata/resolve.h"
#include "strata/shared.h"
#include "strata/solid.h"
#include "strata/transform.h"
#include "strata/version.h"
