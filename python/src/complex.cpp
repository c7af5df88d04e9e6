#include "strata/complex.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <array>

#include "arrays.h"
#include "module.h"
#include "names.h"
#include "run.h"

namespace strata::python {

namespace {

using namespace nb::literals;
using complex::Border;
using complex::SelectiveComplex;

Border border_of(bool open) { return open ? Border::open : Border::closed; }

SelectiveComplex simplex_of(const ArrayLike& corners, bool open) {
  const MeshHandle held = points_of(corners.object, "corners");
  if (!held->owned.exact.empty()) throw std::invalid_argument("corners: expected numbers that are doubles");
  return run([&] { return complex::simplex(3, held->view.vertices, border_of(open)); });
}

template <SelectiveComplex (*operation)(const SelectiveComplex&)>
SelectiveComplex applied(const SelectiveComplex& s) {
  return run([&] { return operation(s); });
}

nb::dict counts_of(const SelectiveComplex& s) {
  constexpr std::array names{"vertices", "edges", "faces", "volumes"};
  nb::dict counts;
  for (int d = 0; d <= s.dimension(); ++d) counts[names[static_cast<std::size_t>(d)]] = s.count(d);
  return counts;
}

std::string describe(const SelectiveComplex& s) {
  return "SelectiveComplex(" + std::to_string(s.count(0)) + " vertices, " + std::to_string(s.count(1)) + " edges, " +
         std::to_string(s.count(2)) + " faces, " + std::to_string(s.count(3)) + " volumes)";
}

}  // namespace

void bind_complex(nb::module_& m) {
  nb::class_<SelectiveComplex>(
      m, "SelectiveComplex", nb::is_weak_referenceable(),
      R"(A point set of space that need not be regular: open, closed, of mixed dimension, unbounded.

Cells that are pairwise disjoint and cover space, each in the set or not. Always the minimal complex of its set, so
`==` compares point sets. `|`, `&`, `-`, `^`, `~` are not regularized. Immutable.

Parameters
----------
solid : Solid, optional
    Without: the empty set.
open : bool
    Without its boundary.

Examples
--------
>>> a, b = SelectiveComplex(box((0, 0, 0), (1, 1, 1))), SelectiveComplex(box((1, 0, 0), (2, 1, 1)))
>>> (a & b).counts  # the square in which they touch
{'vertices': 4, 'edges': 4, 'faces': 1, 'volumes': 1}
>>> (a & b).volume, (a & b).area
(Fraction(0, 1), 1.0)
)")
      .def("__init__", [](SelectiveComplex* self) { new (self) SelectiveComplex(3); })
      .def(
          "__init__",
          [](SelectiveComplex* self, const Solid& solid, bool open) {
            new (self) SelectiveComplex(run([&] { return complex::of_solid(solid, border_of(open)); }));
          },
          "solid"_a, nb::kw_only(), "open"_a = false)
      .def_static(
          "all", [] { return SelectiveComplex::all(3); }, "All of space.")
      .def_static(
          "simplex", simplex_of, "corners"_a, nb::kw_only(), "open"_a = false,
          R"(The convex hull of one to four points that are affinely independent: point, segment, triangle or tetrahedron.

Examples
--------
>>> SelectiveComplex.simplex([[0, 0, 0], [3, 4, 0]]).length
5.0
)")
      .def(
          "__or__", [](const SelectiveComplex& a, const SelectiveComplex& b) { return run([&] { return a | b; }); },
          nb::is_operator())
      .def(
          "__and__", [](const SelectiveComplex& a, const SelectiveComplex& b) { return run([&] { return a & b; }); },
          nb::is_operator())
      .def(
          "__sub__", [](const SelectiveComplex& a, const SelectiveComplex& b) { return run([&] { return a - b; }); },
          nb::is_operator())
      .def(
          "__xor__", [](const SelectiveComplex& a, const SelectiveComplex& b) { return run([&] { return a ^ b; }); },
          nb::is_operator())
      .def("__invert__", [](const SelectiveComplex& a) { return run([&] { return ~a; }); })
      .def(
          "__eq__", [](const SelectiveComplex& a, const SelectiveComplex& b) { return run([&] { return a == b; }); },
          nb::is_operator(), nb::sig("def __eq__(self, other: object, /) -> bool"))
      .def("__hash__",
           [](const SelectiveComplex& s) {
             return s.count(0) + 31 * (s.count(1) + 31 * (s.count(2) + 31 * s.count(3)));
           })
      .def("__bool__", [](const SelectiveComplex& s) { return !s.is_empty(); })
      .def("__repr__", describe)
      .def("interior", applied<complex::interior>, "The points with a neighbourhood in the set.")
      .def("closure", applied<complex::closure>, "The points whose neighbourhoods all meet the set.")
      .def("boundary", applied<complex::boundary>, "The points whose neighbourhoods meet the set and its complement.")
      .def("exterior", applied<complex::exterior>, "The interior of the complement.")
      .def("regularized", applied<complex::regularized>, "The closure of the interior.")
      .def("membrane", applied<complex::membrane>, "The common boundary of interior and exterior.")
      .def("dangle", applied<complex::dangle>, "The rest of the boundary: walls, hair and cuts.")
      .def(
          "components", [](const SelectiveComplex& s) { return run([&] { return complex::separate(s); }); },
          "The connected components, each as a set.")
      .def(
          "contains",
          [](const SelectiveComplex& s, const Point& point) {
            const RationalPoint p = point.value("point");
            return run([&] { return complex::contains(s, p); });
          },
          "point"_a, "Whether a point is in the set. Exact, O(n).")
      .def_prop_ro("counts", counts_of, nb::sig("def counts(self) -> dict[str, int]"),
                   "How many cells of each dimension the minimal complex has.")
      .def_prop_ro("is_bounded", &SelectiveComplex::is_bounded, "Whether it lies in some ball.")
      .def_prop_ro(
          "is_open", [](const SelectiveComplex& s) { return complex::is_open(s); }, "Equal to its interior.")
      .def_prop_ro(
          "is_closed", [](const SelectiveComplex& s) { return complex::is_closed(s); }, "Equal to its closure.")
      .def_prop_ro(
          "is_manifold", [](const SelectiveComplex& s) { return complex::is_manifold(s); },
          "Whether the boundary is a surface everywhere.")
      .def_prop_ro(
          "volume", [](const SelectiveComplex& s) { return run([&] { return complex::volume(s); }); },
          "The exact volume; None where it is unbounded.")
      .def_prop_ro(
          "area", [](const SelectiveComplex& s) { return run([&] { return complex::area(s); }); },
          "The area of its faces, to a few units in the last place; None where one is unbounded.")
      .def_prop_ro(
          "length", [](const SelectiveComplex& s) { return run([&] { return complex::length(s); }); },
          "The length of its edges, to a few units in the last place.");
}

}  // namespace strata::python
