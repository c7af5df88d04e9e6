#include "module.h"

#include "errors.h"

NB_MODULE(_native, m) {
  using namespace strata::python;
  m.doc() = "Exact Booleans of solids: the functions beneath strata_csg.";
  m.attr("version") = STRATA_PYTHON_VERSION;
  // Other packages may hold solids when the interpreter ends, which is no defect; a test of its own looks for leaks.
  nanobind::set_leak_warnings(false);
  register_errors();
  bind_mesh(m);
  bind_solid(m);
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
}
