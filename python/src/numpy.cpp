#include "numpy.h"

#include <nanobind/stl/string.h>

#include <cstdint>
#include <limits>

#include "text.h"

namespace strata::python {

namespace {

/// Whether an array of numpy.ma hides some of its numbers.
bool is_masked(nb::handle object) { return nb::cast<bool>(numpy().attr("ma").attr("is_masked")(object)); }

}  // namespace

bool is_array(nb::handle object) {
  static PyObject* type = nullptr;  // kept for ever; it is written with the lock held
  if (type == nullptr) type = nb::object(numpy().attr("ndarray")).release().ptr();
  if (Py_TYPE(object.ptr()) == reinterpret_cast<PyTypeObject*>(type)) return true;
  return nb::isinstance(object, type) && !is_masked(object);
}

nb::object array_from(nb::handle source, const std::string& role, const char* expected) {
  if (is_masked(source)) throw_value_error(role + ": some numbers are masked; fill them or leave their rows out");
  try {
    return numpy().attr("asarray")(source);
  } catch (nb::python_error& error) {
    if (!error.matches(PyExc_ValueError)) throw;
    throw_value_error(role + ": expected an array of shape " + expected + ", found rows of different lengths");
  }
}

std::string kind_of(nb::handle array) { return nb::cast<std::string>(array.attr("dtype").attr("kind")); }

std::size_t item_size(nb::handle array) { return nb::cast<std::size_t>(array.attr("itemsize")); }

std::size_t size_of(nb::handle array) { return nb::cast<std::size_t>(array.attr("size")); }

nb::object indices_of(const nb::object& array, const std::string& role) {
  const std::string kind = kind_of(array);
  if (size_of(array) != 0) {
    if (kind != "i" && kind != "u")
      throw_type_error(role + ": expected integers, found type " + text_of(array.attr("dtype")));
    if (kind == "i" && array.attr("min")() < nb::int_(0))
      throw_value_error(role + ": index " + text_of(array.attr("min")()) + " is negative");
    if (array.attr("max")() > nb::int_(std::numeric_limits<std::uint32_t>::max()))
      throw_value_error(role + ": index " + text_of(array.attr("max")()) + " is beyond 32 bits");
  }
  return contiguous(array, "uint32");
}

}  // namespace strata::python
