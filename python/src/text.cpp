#include "text.h"

#include <nanobind/stl/string.h>

namespace strata::python {

std::string text_of(nb::handle object) { return nb::cast<std::string>(nb::str(object)); }

std::string type_of(nb::handle object) { return text_of(object.type().attr("__name__")); }

nb::object decoded(std::string_view text) {
  return nb::steal(PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "surrogateescape"));
}

std::string encoded(nb::handle object, const char* role) {
  if (!nb::isinstance<nb::str>(object))
    throw_type_error(std::string(role) + ": expected a str, found " + type_of(object));
  const nb::object bytes = nb::steal(PyUnicode_AsEncodedString(object.ptr(), "utf-8", "surrogateescape"));
  if (!bytes.is_valid()) throw nb::python_error();
  const auto text = nb::borrow<nb::bytes>(bytes);
  return {text.c_str(), text.size()};
}

}  // namespace strata::python
