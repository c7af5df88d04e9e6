#pragma once
// What works on the inside of partitions includes this: the types that bsp.h only names.
#include "core/kernel/hyperplane_table.h"
#include "extensions/bsp/boundary.h"
#include "extensions/bsp/build.h"
#include "extensions/bsp/tree.h"
#include "strata/bsp.h"
