#pragma once
/// Exceptions and defects of the library as those of Python (strata_csg/_errors.py).
#include <nanobind/nanobind.h>
#include <strata/errors.h>

#include <span>

namespace strata::python {

namespace nb = nanobind;

/// A tuple of strata_csg.Defect.
[[nodiscard]] nb::tuple to_python(std::span<const Defect> defects);

/// From here on, exceptions of the library become InputError, FileError, ParseError and InternalError; those of the
/// standard library ValueError, OverflowError and MemoryError.
void register_errors();

}  // namespace strata::python
