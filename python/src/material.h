#pragma once
/// Materials and images, which are records of Python (strata_csg/_attributes.py).
#include <nanobind/nanobind.h>
#include <strata/attributes.h>

namespace strata::python {

namespace nb = nanobind;

/// Throws TypeError with `role` for what is no Material.
[[nodiscard]] Material material_of(nb::handle object, const char* role);
[[nodiscard]] nb::object to_python(const Material& material);

/// Throws TypeError for what is no Image.
[[nodiscard]] Image image_of(nb::handle object);
[[nodiscard]] nb::object to_python(const Image& image);

}  // namespace strata::python
