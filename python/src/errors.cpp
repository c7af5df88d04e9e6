#include "errors.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <strata/openscad.h>
#include <strata/planar.h>

#include <exception>
#include <stdexcept>
#include <typeinfo>

#include "text.h"

namespace strata::python {

namespace {

nb::object module() { return nb::module_::import_("strata_csg._errors"); }

template <class T>
nb::tuple tuple_of(const T& values) {
  nb::list list;
  for (const auto& value : values) list.append(value);
  return nb::tuple(list);
}

nb::object record_of(const Defect& defect) {
  nb::object where = nb::none();
  if (defect.where) where = tuple_of(*defect.where);
  return module().attr("Defect")(name(defect.kind), name(defect.severity), where, tuple_of(defect.faces), defect.count,
                                 defect.message, defect.remedy, describe(defect));
}

/// Sets Python's exception of that class.
template <class... A>
void raise(const char* type, const A&... arguments) {
  const nb::object exception = module().attr(type)(arguments...);
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(exception.ptr())), exception.ptr());
}

void translate_own(const std::exception_ptr& exception) {
  try {
    std::rethrow_exception(exception);
  } catch (const InputError& error) {
    raise("InputError", error.what(), strata::python::to_python(std::span(error.defects())), error.operand());
  } catch (const IoError& error) {
    raise("FileError", decoded(error.what()), decoded(error.path()), error.line(), error.byte(),
          decoded(error.reason()));
  } catch (const ParseError& error) {
    raise("ParseError", decoded(error.what()), error.position());
  } catch (const CsgError& error) {
    raise("FileError", decoded(error.what()), decoded(error.file()), error.line(), nb::none(), decoded(error.reason()));
  } catch (const planar::UnboundedResult& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  } catch (const LogicError& error) {
    raise("InternalError", error.what());
  } catch (const std::length_error& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  } catch (const std::bad_cast&) {
    PyErr_SetString(PyExc_TypeError, "an object is of another type than expected, or was never initialised");
  }
}

void translate(const std::exception_ptr& exception, void*) {
  try {
    translate_own(exception);
  } catch (nb::python_error& error) {  // of the handler of a signal, while the exception was made
    error.restore();
  }
}

}  // namespace

nb::tuple to_python(std::span<const Defect> defects) {
  nb::list list;
  for (const Defect& defect : defects) list.append(record_of(defect));
  return nb::tuple(list);
}

void register_errors() { nb::register_exception_translator(translate); }

}  // namespace strata::python
