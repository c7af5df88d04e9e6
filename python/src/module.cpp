#include "module.h"

#include "errors.h"
#include "run.h"

NB_MODULE(_native, m) {
  using namespace strata::python;
  m.doc() = "Exact Booleans of solids: the functions beneath strata_csg.";
  m.attr("version") = STRATA_PYTHON_VERSION;
  if (PyInterpreterState_GetID(PyInterpreterState_Get()) != 0)
    throw nanobind::import_error("strata_csg works in the main interpreter only");
  // Other packages may hold solids when the interpreter ends, which is no defect; a test of its own looks for leaks.
  nanobind::set_leak_warnings(false);
  register_errors();
  watch_for_the_end();
  bind_channel(m);
  bind_attributes(m);
  bind_mesh(m);
  bind_solid(m);
  bind_solid_copies(m);
  bind_carry_attributes(m);
  bind_boolean(m);
  bind_check(m);
  bind_primitives(m);
  bind_files(m);
  bind_expression(m);
  bind_workpiece(m);
  bind_surface(m);
  bind_planar(m);
  bind_convex(m);
  bind_contact(m);
  bind_query(m);
  bind_complex(m);
  bind_command_line(m);
  // Immutable values are their own copies.
  for (const char* name : {"Attributes", "Channel", "Mesh", "Surface", "Expression", "Workpiece", "Polygons",
                           "SelectiveComplex", "Locator", "RayCaster", "Layers"}) {
    const nanobind::object type = m.attr(name);
    nanobind::setattr(type, "__copy__",
                      nanobind::cpp_function([](nanobind::object self) { return self; }, nanobind::name("__copy__"),
                                             nanobind::scope(type), nanobind::is_method()));
    nanobind::setattr(type, "__deepcopy__",
                      nanobind::cpp_function([](nanobind::object self, nanobind::object) { return self; },
                                             nanobind::name("__deepcopy__"), nanobind::scope(type),
                                             nanobind::is_method(), nanobind::arg("memo")));
  }
}
