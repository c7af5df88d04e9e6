#pragma once
/// Attributes of meshes between NumPy and the library.
#include <nanobind/nanobind.h>
#include <strata/attributes.h>
#include <strata/solid.h>

#include <memory>
#include <optional>

#include "numbers.h"

namespace strata::python {

/// What a mesh carries, shared; null: nothing.
using AttributesHandle = std::shared_ptr<const Attributes>;

[[nodiscard]] AttributesHandle handle_of(Attributes attributes);
[[nodiscard]] AttributesHandle attributes_of(const Solid& solid);

/// Attributes, or None.
struct AttributesOption {
  nb::object object = nb::none();
  [[nodiscard]] AttributesHandle value() const;
};

/// A Material of strata_csg, or None.
struct MaterialOption {
  nb::object object = nb::none();
  [[nodiscard]] std::optional<Material> value(const char* role) const;
};

/// The names of the channels, as the texts of meshes have them: ", with color, material"; empty without channels.
[[nodiscard]] std::string names_in(const Attributes& attributes);

}  // namespace strata::python

namespace nanobind::detail {

STRATA_ARGUMENT(strata::python::AttributesOption, "Attributes");
STRATA_ARGUMENT(strata::python::MaterialOption, "Material");

}  // namespace nanobind::detail
