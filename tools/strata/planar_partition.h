#pragma once
#include <span>

#include "strata/planar.h"

/// As `combine`, by merging binary space partitions of the plane: the same region by other mathematics. Throws
/// UsageError without the extension bsp, strata::Cancelled.
[[nodiscard]] strata::planar::Region combine_by_partitions(std::span<const strata::planar::Operand> operands,
                                                           strata::Operation operation, const strata::Monitor& monitor);
