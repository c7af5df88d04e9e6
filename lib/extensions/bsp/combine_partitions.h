#pragma once
#include <span>

#include "strata/combine.h"

namespace strata {

/// `combine` by merging binary space partitions (`bsp_engine`). The same solid as by the arrangement, divided into other
/// triangles: facets in one plane are merged. The source of a triangle is some face of an operand in its plane.
/// Throws as `combine` does.
[[nodiscard]] BooleanResult combine_partitions(Operation operation, std::span<const Operand> operands,
                                               const Options& options);

}  // namespace strata
