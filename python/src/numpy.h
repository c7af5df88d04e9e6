#pragma once
/// What is asked of NumPy.
#include <nanobind/nanobind.h>

#include <cstddef>
#include <string>

namespace strata::python {

namespace nb = nanobind;

[[nodiscard]] inline nb::module_ numpy() { return nb::module_::import_("numpy"); }

/// Whether an object is one of NumPy's arrays, with no number masked.
[[nodiscard]] bool is_array(nb::handle object);

/// What NumPy makes of an object. Throws ValueError with `role` and `expected` for rows of different lengths, and
/// for masked numbers.
[[nodiscard]] nb::object array_from(nb::handle source, const std::string& role, const char* expected);

/// The letter of NumPy for the kind of an array's numbers, such as "f"; the bytes of one; how many there are.
[[nodiscard]] std::string kind_of(nb::handle array);
[[nodiscard]] std::size_t item_size(nb::handle array);
[[nodiscard]] std::size_t size_of(nb::handle array);

/// The same numbers in C order, in another type.
[[nodiscard]] inline nb::object contiguous(const nb::object& array, const char* type) {
  return numpy().attr("ascontiguousarray")(array, nb::arg("dtype") = type);
}

/// The same integers as uint32, in C order. Throws TypeError and ValueError for what are no numbers of elements.
[[nodiscard]] nb::object indices_of(const nb::object& array, const std::string& role);

}  // namespace strata::python
