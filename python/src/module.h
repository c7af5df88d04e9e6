#pragma once
/// The parts of the extension module, each in a file of that name.
#include <nanobind/nanobind.h>

namespace strata::python {

void bind_channel(nanobind::module_& m);
void bind_attributes(nanobind::module_& m);
void bind_mesh(nanobind::module_& m);
void bind_solid(nanobind::module_& m);
void bind_solid_copies(nanobind::module_& m);
void bind_carry_attributes(nanobind::module_& m);
void bind_boolean(nanobind::module_& m);
void bind_check(nanobind::module_& m);
void bind_primitives(nanobind::module_& m);
void bind_files(nanobind::module_& m);
void bind_expression(nanobind::module_& m);
void bind_workpiece(nanobind::module_& m);
void bind_surface(nanobind::module_& m);
void bind_convex(nanobind::module_& m);
void bind_contact(nanobind::module_& m);
void bind_query(nanobind::module_& m);
void bind_planar(nanobind::module_& m);
void bind_complex(nanobind::module_& m);
void bind_command_line(nanobind::module_& m);

}  // namespace strata::python
