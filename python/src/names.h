#pragma once
/// Values of enumerations, planes and grids as arguments from Python.
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <strata/attributes.h>
#include <strata/carry_attributes.h>
#include <strata/convex.h>
#include <strata/options.h>
#include <strata/plane.h>
#include <strata/solid.h>
#include <strata/surface.h>
#include <strata/unit.h>

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "numbers.h"

namespace strata::python {

namespace nb = nanobind;

/// The value of that name; throws ValueError that lists the names. `name_of` gives the name of a value.
template <class All, class NameOf>
auto named(nb::handle text, const char* role, const All& all, NameOf name_of) {
  std::string found;
  if (!nb::try_cast(text, found))
    throw nb::type_error(
        (std::string(role) + ": expected a name, found " + nb::cast<std::string>(nb::repr(text))).c_str());
  std::string names;
  for (const auto value : all) {
    if (found == name_of(value)) return value;
    names += (names.empty() ? "" : ", ") + std::string(name_of(value));
  }
  throw nb::value_error((std::string(role) + ": expected one of " + names + ", found '" + found + "'").c_str());
}

struct OperationName {
  nb::object object;
  [[nodiscard]] Operation value() const;  ///< also `xor`
};
struct InputName {
  nb::object object;
  [[nodiscard]] InputClass value() const;
};
struct InsideName {
  nb::object object;
  [[nodiscard]] Inside value() const;
};
struct ClipName {
  nb::object object;
  [[nodiscard]] ClipTo value() const;
};
struct ElementName {
  nb::object object;
  [[nodiscard]] Element value() const;
};
struct InterpolationName {
  nb::object object = nb::none();
  [[nodiscard]] Interpolation value() const;
};
struct CutFacesName {
  nb::object object;
  [[nodiscard]] CutFaces value() const;
};
/// Also None, which is `none`, and the short names.
struct UnitName {
  nb::object object = nb::none();
  [[nodiscard]] Unit value() const;
};

[[nodiscard]] const char* name_of(Element element);
[[nodiscard]] const char* name_of(Interpolation interpolation);
/// None for `none`.
[[nodiscard]] nb::object name_of(Unit unit);

/// None, "float64", "float32", or a step.
struct Grid {
  nb::object object;
  [[nodiscard]] std::optional<CoordinateGrid> value() const;
};

/// A pair of a normal and an offset: the points p with normal . p = offset.
struct PlanePair {
  nb::object object;
  [[nodiscard]] Plane value() const;
};

/// A matrix of 3 or 4 rows of 4 numbers.
struct Matrix {
  nb::object object;
  [[nodiscard]] Transform value() const;
};

/// None, or the name of another engine: bsp, layers.
[[nodiscard]] const Engine* engine_named(nb::handle name);

/// The solids of an iterable. Throws TypeError for other members.
struct SolidList {
  nb::object object;
  [[nodiscard]] std::vector<Solid> value(const char* role = "solids") const;
};

}  // namespace strata::python

namespace nanobind::detail {

STRATA_ARGUMENT(strata::python::OperationName, "Operation");
STRATA_ARGUMENT(strata::python::InputName, "InputClass");
STRATA_ARGUMENT(strata::python::InsideName, "typing.Literal['winding', 'even-odd', 'outer']");
STRATA_ARGUMENT(strata::python::ClipName, "typing.Literal['inside', 'outside', 'on']");
STRATA_ARGUMENT(strata::python::ElementName, "Element");
STRATA_ARGUMENT(strata::python::InterpolationName, "Interpolation | None");
STRATA_ARGUMENT(strata::python::CutFacesName, "typing.Literal['turned', 'of-later-operands']");
STRATA_ARGUMENT(strata::python::UnitName, "str");
STRATA_ARGUMENT(strata::python::Grid, "Number | str | None");
STRATA_ARGUMENT(strata::python::PlanePair, "PlaneLike");
STRATA_ARGUMENT(strata::python::Matrix, "MatrixLike");
STRATA_ARGUMENT(strata::python::SolidList, "collections.abc.Iterable[Solid]");

}  // namespace nanobind::detail
