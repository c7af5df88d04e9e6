#pragma once
#include "common/json_location.h"
#include "strata/transform.h"

/// A transform from its matrix in JSON: four rows of four, the last of them a multiple of 0 0 0 1; points are columns.
/// Coefficients are numbers (integers of up to 64 bits as they are, all others stand for the nearest double) or strings
/// with integers or quotients of integers, of any length: "-1/3". Throws strata::IoError with the place, also for
/// determinant 0.
[[nodiscard]] strata::Transform read_matrix(const JsonLocation& place);
