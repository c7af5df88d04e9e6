#pragma once
#include "common/json_location.h"
#include "strata/mesh.h"

namespace verify {

/// The mesh of a generator line, {"generate": FAMILY, ...}: generators.md lists families and parameters. The same
/// coordinates on every machine: sums, products, quotients and square roots of doubles only.
/// Throws strata::IoError, which names the field.
[[nodiscard]] strata::Mesh generate(const JsonLocation& line);

}  // namespace verify
