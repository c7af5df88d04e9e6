#pragma once
/// Texts between Python and the library, and errors with texts that are made when they are thrown.
#include <nanobind/nanobind.h>

#include <string>
#include <string_view>

namespace strata::python {

namespace nb = nanobind;

[[noreturn]] inline void throw_type_error(const std::string& message) { throw nb::type_error(message.c_str()); }
[[noreturn]] inline void throw_value_error(const std::string& message) { throw nb::value_error(message.c_str()); }

/// As str() writes it.
[[nodiscard]] std::string text_of(nb::handle object);
/// The type of an object, as messages name it.
[[nodiscard]] std::string type_of(nb::handle object);

/// A str of what should be UTF-8 but need not be, such as names in files: other bytes become surrogates, as in paths.
[[nodiscard]] nb::object decoded(std::string_view text);
/// The inverse. Throws TypeError that names the argument where the object is no str.
[[nodiscard]] std::string encoded(nb::handle object, const char* role);

}  // namespace strata::python
