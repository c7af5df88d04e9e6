#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <strata/expression.h>
#include <strata/openscad.h>

#include <stdexcept>

#include "attributes.h"
#include "module.h"
#include "names.h"
#include "run.h"

namespace strata::python {

namespace {

using namespace nb::literals;

Expression parsed(const std::string& text, const nb::dict& solids) {
  return parse_expression(text, [&](const std::string& name) {
    const nb::object solid = solids.attr("get")(name);
    if (!nb::isinstance<Solid>(solid)) throw std::out_of_range("there is no solid of the name " + name);
    return nb::cast<Solid>(solid);
  });
}

nb::list primitives_of(const Expression& expression) {
  nb::list primitives;
  for (const Expression::Primitive& p : expression.primitives())
    primitives.append(nb::make_tuple(p.name, p.solid, p.positive, p.negative, p.matters));
  return primitives;
}

}  // namespace

void bind_expression(nb::module_& m) {
  nb::class_<Expression> type(m, "Expression", nb::is_weak_referenceable(),
                              R"(A Boolean expression of solids: nothing is computed before it is evaluated.

All of it is then evaluated in one arrangement, so that a chain of thousands of operations is exact without growing
fractions. `|`, `&`, `-`, `^` combine expressions and solids; `~` is the complement, which is allowed everywhere but in
what is evaluated. Immutable.

Parameters
----------
solid : Solid
name : str
    For texts and messages.

Examples
--------
>>> part = Expression(box((0, 0, 0), (4, 4, 4)), "block") - Expression(box((1, 1, 1), (2, 2, 5)), "hole")
>>> part
Expression(block - hole)
>>> part.evaluate().volume
Fraction(61, 1)
)");
  type.def(nb::init<Solid, std::string>(), "solid"_a, "name"_a = "")
      .def_static("parse", parsed, "text"_a, "solids"_a,
                  nb::sig("def parse(text: str, solids: dict[str, Solid]) -> Expression"),
                  R"(Reads an expression such as ``(a - b) & (c | ~d)``.

Parameters
----------
text : str
    Names, and | & - ^ ~ and parentheses; ~ binds strongest, then - and +, then &, then ^, then |.
solids : dict
    The solids of the names.

Raises
------
ParseError
    The text does not follow the grammar, or has a name that is not in `solids`.

Examples
--------
>>> solids = {"a": box((0, 0, 0), (2, 2, 2)), "b": box((1, 1, 1), (3, 3, 3))}
>>> Expression.parse("a - b", solids).evaluate().volume
Fraction(7, 1)
)")
      .def_static(
          "any", [](const std::vector<Expression>& terms) { return Expression::any(terms); }, "terms"_a,
          nb::sig("def any(terms: collections.abc.Sequence[Expression | Solid]) -> Expression"),
          "The union of any number of expressions.")
      .def_static(
          "all", [](const std::vector<Expression>& terms) { return Expression::all(terms); }, "terms"_a,
          nb::sig("def all(terms: collections.abc.Sequence[Expression | Solid]) -> Expression"),
          "The intersection of one or more expressions.")
      .def_static(
          "odd", [](const std::vector<Expression>& terms) { return Expression::odd(terms); }, "terms"_a,
          nb::sig("def odd(terms: collections.abc.Sequence[Expression | Solid]) -> Expression"),
          "What is in an odd number of expressions.")
      .def(
          "__or__", [](const Expression& a, const Expression& b) { return a | b; }, nb::is_operator(),
          nb::sig("def __or__(self, other: Expression | Solid, /) -> Expression"))
      .def(
          "__and__", [](const Expression& a, const Expression& b) { return a & b; }, nb::is_operator(),
          nb::sig("def __and__(self, other: Expression | Solid, /) -> Expression"))
      .def(
          "__sub__", [](const Expression& a, const Expression& b) { return a - b; }, nb::is_operator(),
          nb::sig("def __sub__(self, other: Expression | Solid, /) -> Expression"))
      .def(
          "__xor__", [](const Expression& a, const Expression& b) { return a ^ b; }, nb::is_operator(),
          nb::sig("def __xor__(self, other: Expression | Solid, /) -> Expression"))
      .def(
          "__ror__", [](const Expression& b, const Solid& a) { return a | b; }, nb::is_operator())
      .def(
          "__rand__", [](const Expression& b, const Solid& a) { return a & b; }, nb::is_operator())
      .def(
          "__rsub__", [](const Expression& b, const Solid& a) { return a - b; }, nb::is_operator())
      .def(
          "__rxor__", [](const Expression& b, const Solid& a) { return a ^ b; }, nb::is_operator())
      .def("__invert__", [](const Expression& a) { return ~a; })
      .def("__len__", &Expression::size)
      .def("__repr__", [](const Expression& e) { return "Expression(" + e.text() + ")"; })
      .def("__str__", &Expression::text)
      .def(
          "transformed",
          [](const Expression& e, const Matrix& matrix, bool rounded) {
            return e.transformed(matrix.value(), rounded ? Placement::rounded : Placement::exact);
          },
          "matrix"_a, nb::kw_only(), "rounded"_a = false,
          "The image under an affine map, as `Solid.transformed`. Maps of maps are multiplied before a vertex moves.")
      .def(
          "evaluate",
          [](const Expression& e, const MaterialOption& cut_material, unsigned threads, ProgressOption progress,
             std::optional<double> timeout) {
            return run({threads, std::move(progress), timeout, cut_material.value("cut_material")},
                       [&](const Computation& c) { return e.evaluate(c.options()); });
          },
          nb::kw_only(), "cut_material"_a = nb::none(), STRATA_WATCH_ARGUMENTS, R"(The solid, in one arrangement.

Attributes of the solids are carried; `cut_material` is for faces that come out turned over.

Raises
------
ValueError
    The expression is not bounded, as a complement is.
)")
      .def_prop_ro("primitives", primitives_of,
                   nb::sig("def primitives(self) -> list[tuple[str, Solid, bool, bool, bool]]"),
                   "The different solids in order: name, solid, whether it occurs as it is, whether it occurs "
                   "complemented, whether the result depends on it.");
  nb::implicitly_convertible<Solid, Expression>();
  nb::class_<Solid> solid = nb::borrow<nb::class_<Solid>>(m.attr("Solid"));
  solid.def("__invert__", [](const Solid& s) { return ~Expression(s); });
  m.def(
      "read_openscad",
      [](nb::object path) {
        const std::string name = nb::cast<std::string>(nb::module_::import_("os").attr("fspath")(path));
        return run([&] { return read_csg_file(name).expression; });
      },
      "path"_a, nb::sig("def read_openscad(path: str | os.PathLike[str]) -> Expression"),
      R"(Reads a model in the .csg format that OpenSCAD writes (``openscad -o part.csg part.scad``).

Raises
------
FileError
    The file cannot be read, or uses what is not supported; `line` says where.
)");
}

}  // namespace strata::python
