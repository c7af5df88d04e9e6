#include <nanobind/stl/array.h>
#include <nanobind/stl/vector.h>
#include <strata/primitives.h>

#include <cmath>
#include <stdexcept>

#include "arrays.h"
#include "module.h"
#include "numbers.h"
#include "run.h"

namespace strata::python {

namespace {

/// Of corners that need not be doubles.
Solid exact_box(const RationalPoint& lower, const RationalPoint& upper) {
  Vertex from{}, to{};
  bool is_of_doubles = true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (lower[i] >= upper[i]) throw std::invalid_argument("box: expected lower < upper in every coordinate");
    from[i] = to_nearest_double(lower[i]);
    to[i] = to_nearest_double(upper[i]);
    is_of_doubles = is_of_doubles && std::isfinite(from[i]) && std::isfinite(to[i]) && Rational(from[i]) == lower[i] &&
                    Rational(to[i]) == upper[i];
  }
  if (is_of_doubles) return make_box(from, to);
  const RationalPoint size{upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]};
  return make_box({0, 0, 0}, {1, 1, 1}).scaled(size).translated(lower);
}

/// Pairs of numbers that are doubles.
std::vector<std::array<double, 2>> corners_of(nb::handle polygon) {
  std::vector<std::array<double, 2>> corners;
  for (const nb::handle pair : polygon) {
    std::vector<double> corner;
    for (const nb::handle x : pair) {
      corner.push_back(Number{nb::borrow(x)}.as_double("polygon"));
      if (corner.size() > 2) break;
    }
    if (corner.size() != 2) throw nb::value_error("polygon: expected pairs of numbers");
    corners.push_back({corner[0], corner[1]});
  }
  return corners;
}

}  // namespace

void bind_primitives(nb::module_& m) {
  using namespace nb::literals;
  m.def(
      "box",
      [](const Point& lower, const Point& upper) { return exact_box(lower.value("lower"), upper.value("upper")); },
      "lower"_a, "upper"_a, R"(The box with opposite corners `lower` and `upper`, numbers of any kind, taken exactly.

Raises
------
ValueError
    Unless lower < upper in every coordinate.

Examples
--------
>>> box((0, 0, 0), (1, 2, 3)).volume
Fraction(6, 1)
)");
  m.def(
      "tetrahedron",
      [](const Point& a, const Point& b, const Point& c, const Point& d) {
        return make_tetrahedron(a.doubles("a"), b.doubles("b"), c.doubles("c"), d.doubles("d"));
      },
      "a"_a, "b"_a, "c"_a, "d"_a, R"(The tetrahedron with these corners, in any order.

Examples
--------
>>> tetrahedron((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)).volume
Fraction(1, 6)
)");
  m.def(
      "cylinder",
      [](const Number& radius, const Number& height, std::uint32_t sides) {
        return make_cylinder(radius.as_double("radius"), height.as_double("height"), sides);
      },
      "radius"_a, "height"_a, "sides"_a = 64,
      R"(A cylinder about the z axis from z = 0: a prism over a regular polygon inscribed in the circle.

Examples
--------
>>> cylinder(1, 2, 4).volume
Fraction(4, 1)
)");
  m.def(
      "cone",
      [](const Number& lower, const Number& upper, const Number& height, std::uint32_t sides) {
        return make_cone(lower.as_double("lower_radius"), upper.as_double("upper_radius"), height.as_double("height"),
                         sides);
      },
      "lower_radius"_a, "upper_radius"_a, "height"_a, "sides"_a = 64,
      R"(A cone about the z axis, with `lower_radius` at z = 0 and `upper_radius` at z = height; one of them may be 0.

Examples
--------
>>> cone(1, 0, 3, 4).volume
Fraction(2, 1)
)");
  m.def(
      "sphere",
      [](const Number& radius, std::uint32_t sides) {
        const double r = radius.as_double("radius");
        return run([&] { return make_sphere(r, sides); });
      },
      "radius"_a, "sides"_a = 64,
      R"(A polyhedron inscribed in the sphere about the origin: circles of latitude of `sides` corners each.

Examples
--------
>>> sphere(1, 4).volume
Fraction(4, 3)
)");
  m.def(
      "torus",
      [](const Number& radius, const Number& tube_radius, std::uint32_t sides, std::uint32_t tube_sides) {
        const double r = radius.as_double("radius"), tube = tube_radius.as_double("tube_radius");
        return run([&] { return make_torus(r, tube, sides, tube_sides); });
      },
      "radius"_a, "tube_radius"_a, "sides"_a = 64, "tube_sides"_a = 32,
      R"(A torus about the z axis. `sides` corners on the great circle, `tube_sides` on the small one.

Examples
--------
>>> float(torus(2, 1, 4, 4).volume)
16.0
)");
  m.def(
      "prism",
      [](const ArrayLike& polygon, const Number& lower, const Number& upper) {
        const auto corners = corners_of(polygon.object);
        const double from = lower.as_double("lower"), to = upper.as_double("upper");
        return run([&] { return make_prism(corners, from, to); });
      },
      "polygon"_a, "lower"_a, "upper"_a, R"(A simple polygon in the plane, extruded from z = lower to z = upper.

Parameters
----------
polygon : sequence of pairs of float
    Corners in either direction.

Raises
------
InputError
    Where the polygon crosses or touches itself.

Examples
--------
>>> prism([(0, 0), (2, 0), (0, 2)], 0, 1).volume
Fraction(2, 1)
)");
}

}  // namespace strata::python
