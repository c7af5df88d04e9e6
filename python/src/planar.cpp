#include "strata/planar.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <strata/section.h>

#include <array>

#include "arrays.h"
#include "module.h"
#include "names.h"
#include "run.h"

namespace strata::python {

namespace {

using namespace nb::literals;
using planar::Region;

/// A Region is plain data; a handle makes it a value that Python shares.
struct Polygons {
  Shared<Region> region;
};

Polygons shared(Region region) { return {Shared<Region>::make(std::move(region))}; }

std::array<Rational, 2> place_of(nb::handle point, const char* role) {
  std::array<Rational, 2> place;
  std::size_t count = 0;
  for (const nb::handle x : point) {
    if (count < 2) place[count] = to_rational(x, role);
    ++count;
  }
  if (count != 2) throw nb::value_error((std::string(role) + ": expected pairs of numbers").c_str());
  return place;
}

void add_loop(planar::LoopsBuilder& builder, nb::handle points) {
  std::vector<std::array<Rational, 2>> loop;
  for (const nb::handle point : points) loop.push_back(place_of(point, "loops"));
  // Rings of GeoJSON repeat their first point.
  if (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
  for (auto& place : loop) builder.add_vertex(std::move(place));
  builder.end_loop();
}

planar::Loops loops_of(nb::handle loops) {
  planar::LoopsBuilder builder;
  for (const nb::handle loop : loops) add_loop(builder, loop);
  return builder.finish();
}

planar::FillRule rule_of(nb::handle name) {
  using enum planar::FillRule;
  return named(name, "fill", std::array{even_odd, nonzero, positive, negative}, [](planar::FillRule rule) {
    constexpr std::array names{"even-odd", "nonzero", "positive", "negative"};
    return names[static_cast<std::size_t>(rule)];
  });
}

Polygons filled(nb::handle loops, nb::handle rule) {
  const planar::Loops given = loops_of(loops);
  const planar::FillRule fill = rule_of(rule);
  return run([&] { return shared(planar::fill({given, fill})); });
}

/// The polygon of GeoJSON coordinates: a shell, then holes; rings may run either way.
Polygons polygon_of(nb::handle rings) {
  std::vector<Polygons> parts;
  for (const nb::handle ring : rings) {
    planar::LoopsBuilder builder;
    add_loop(builder, ring);
    const planar::Loops loop = builder.finish();
    parts.push_back(run([&] { return shared(planar::fill({loop, planar::FillRule::nonzero})); }));
  }
  if (parts.empty()) return shared({});
  std::vector<planar::Operand> operands;
  for (const Polygons& part : parts) operands.emplace_back(*part.region);
  return run([&] { return shared(planar::combine(operands, Operation::difference)); });
}

Polygons united(const std::vector<Polygons>& parts) {
  std::vector<planar::Operand> operands;
  for (const Polygons& part : parts) operands.emplace_back(*part.region);
  return run([&] { return shared(planar::combine(operands, Operation::union_)); });
}

/// Counts calls that contain one another; throws RecursionError where there are too many.
class RecursiveCall {
 public:
  RecursiveCall() {
    if (Py_EnterRecursiveCall(" in a geometry") != 0) throw nb::python_error();
  }
  RecursiveCall(const RecursiveCall&) = delete;
  RecursiveCall& operator=(const RecursiveCall&) = delete;
  ~RecursiveCall() { Py_LeaveRecursiveCall(); }
};

/// Of a geometry as GeoJSON describes it.
Polygons polygons_of(nb::handle geometry) {
  const RecursiveCall call;
  const auto type = nb::cast<std::string>(nb::object(geometry["type"]));
  if (type == "Polygon") return polygon_of(geometry["coordinates"]);
  std::vector<Polygons> parts;
  if (type == "MultiPolygon") {
    for (const nb::handle polygon : nb::object(geometry["coordinates"])) parts.push_back(polygon_of(polygon));
  } else if (type == "GeometryCollection") {
    for (const nb::handle member : nb::object(geometry["geometries"])) parts.push_back(polygons_of(member));
  } else if (type == "Feature") {
    return polygons_of(nb::object(geometry["geometry"]));
  } else if (type == "FeatureCollection") {
    for (const nb::handle member : nb::object(geometry["features"])) parts.push_back(polygons_of(member));
  } else {
    throw nb::value_error(("geometry: expected polygons, found " + type).c_str());
  }
  return united(parts);
}

nb::object from_geo(nb::handle object) {
  nb::object geometry = nb::borrow(object);
  if (nb::hasattr(object, "__geo_interface__")) geometry = object.attr("__geo_interface__");
  if (!nb::isinstance<nb::dict>(geometry))
    throw nb::type_error("geometry: expected a mapping as of GeoJSON, or an object with __geo_interface__");
  return nb::cast(polygons_of(geometry));
}

/// The closed ring of a loop, in nearest doubles.
nb::tuple ring_of(const Region& region, std::uint32_t loop) {
  nb::list ring;
  const auto vertices = region.loops.loop(loop);
  for (std::size_t i = 0; i <= vertices.size(); ++i) {
    const planar::PlanePoint p = planar::nearest_place(region.loops.places, vertices[i % vertices.size()]);
    ring.append(nb::make_tuple(p[0], p[1]));
  }
  return nb::tuple(ring);
}

nb::dict geo_interface(const Polygons& polygons) {
  const Region& region = *polygons.region;
  nb::list coordinates;
  for (std::uint32_t p = 0; p < region.polygons(); ++p) {
    nb::list rings;
    for (std::uint32_t l = region.first_loop[p]; l < region.first_loop[p + 1]; ++l) rings.append(ring_of(region, l));
    coordinates.append(nb::tuple(rings));
  }
  nb::dict geometry;
  geometry["type"] = "MultiPolygon";
  geometry["coordinates"] = nb::tuple(coordinates);
  return geometry;
}

/// Per polygon its loops, each a list of points of Fractions.
nb::list exact_loops(const Polygons& polygons) {
  const Region& region = *polygons.region;
  nb::list all;
  for (std::uint32_t p = 0; p < region.polygons(); ++p) {
    nb::list loops;
    for (std::uint32_t l = region.first_loop[p]; l < region.first_loop[p + 1]; ++l) {
      nb::list points;
      for (const std::uint32_t v : region.loops.loop(l))
        points.append(to_python(exact_position(region.loops.places, v)));
      loops.append(points);
    }
    all.append(loops);
  }
  return all;
}

Polygons combined(Operation operation, const Polygons& a, const Polygons& b) {
  const std::array operands{planar::Operand(*a.region), planar::Operand(*b.region)};
  return run({}, [&](const Computation& c) { return shared(planar::combine(operands, operation, c.monitor())); });
}

Polygons rounded(const Polygons& polygons, const Grid& to) {
  const CoordinateGrid grid = to.value().value_or(CoordinateGrid{});
  return run({}, [&](const Computation& c) {
    return shared(planar::round_to_region(*polygons.region, grid, c.monitor()).region);
  });
}

std::string text_of(const Polygons& polygons, const std::string& format, bool exact) {
  const auto kind = planar::planar_format_named(format);
  if (!kind) throw nb::value_error(("format: expected one of wkt, geojson, svg, found '" + format + "'").c_str());
  if (exact && *kind != planar::PlanarFormat::wkt) throw nb::value_error("format: WKT alone has exact coordinates");
  return run([&] {
    return planar::to_text(*polygons.region, *kind, exact ? planar::Coordinates::exact : planar::Coordinates::nearest);
  });
}

Polygons parsed(const std::string& text, const std::string& format) {
  const auto kind = planar::planar_format_named(format);
  if (!kind) throw nb::value_error(("format: expected one of wkt, geojson, svg, found '" + format + "'").c_str());
  return run([&] {
    const planar::PlanarFile file = planar::read_planar(text, *kind, "text");
    return shared(planar::fill(file.loops));
  });
}

int membership(const Polygons& polygons, nb::handle point) {
  const planar::RationalPlacement place = place_of(point, "point");
  switch (planar::Locator(*polygons.region).locate(place)) {
    case planar::Membership::in:
      return 1;
    case planar::Membership::on:
      return 0;
    case planar::Membership::out:
      return -1;
  }
  return -1;
}

std::vector<Polygons> sliced(const Solid& solid, std::size_t axis, const ArrayLike& heights, unsigned threads,
                             ProgressOption progress, std::optional<double> timeout) {
  std::vector<double> at;
  for (const nb::handle x : heights.object) at.push_back(Number{nb::borrow(x)}.as_double("at"));
  return run({threads, std::move(progress), timeout}, [&](const Computation& c) {
    std::vector<Polygons> layers(at.size());
    slice(
        solid, axis, at, [&](std::size_t plane, Region region) { layers[plane] = shared(std::move(region)); },
        c.options());
    return layers;
  });
}

void bind_polygons(nb::module_& m) {
  nb::class_<Polygons>(m, "Polygons", nb::is_weak_referenceable(),
                       R"(A bounded set of the plane: simple polygons with holes. An immutable value, exact.

`|`, `&`, `-`, `^` as for solids. Geometries of shapely and of others with ``__geo_interface__`` go in by `from_geo`, and
``shapely.geometry.shape(polygons)`` takes them out.

Parameters
----------
loops : iterable of loops, each an iterable of pairs of numbers
    Closed polygons, which may cross themselves and each other; numbers of any kind, taken exactly.
fill : {"nonzero", "even-odd", "positive", "negative"}
    Which points loops fill, by how often they wind around them.

Examples
--------
>>> square = Polygons([[(0, 0), (2, 0), (2, 2), (0, 2)]])
>>> (square - Polygons([[(1, 1), (3, 1), (3, 3), (1, 3)]])).area
Fraction(3, 1)
)")
      .def(
          "__init__",
          [](Polygons* self, nb::object loops, nb::object fill) { new (self) Polygons(filled(loops, fill)); },
          "loops"_a = nb::tuple(), nb::kw_only(), "fill"_a = nb::str("nonzero"),
          nb::sig("def __init__(self, loops: collections.abc.Iterable[collections.abc.Iterable[typing.Any]] = (), *, "
                  "fill: typing.Literal['nonzero', 'even-odd', 'positive', 'negative'] = 'nonzero') -> None"))
      .def_static("from_geo", from_geo, "geometry"_a, nb::sig("def from_geo(geometry: typing.Any) -> Polygons"),
                  R"(Of polygons as GeoJSON describes them, or of an object with ``__geo_interface__``.

Examples
--------
>>> Polygons.from_geo({"type": "Polygon", "coordinates": [[(0, 0), (1, 0), (1, 1), (0, 0)]]}).area
Fraction(1, 2)
)")
      .def_static("parse", parsed, "text"_a, "format"_a = "wkt", R"doc(Reads WKT, GeoJSON, or the paths of SVG.

Examples
--------
>>> Polygons.parse("POLYGON ((0 0, 1/3 0, 0 1))").area
Fraction(1, 6)
)doc")
      .def("text", text_of, "format"_a = "wkt", nb::kw_only(), "exact"_a = false,
           "As WKT, GeoJSON or SVG; in WKT also with exact coordinates, as quotients.")
      .def(
          "__or__", [](const Polygons& a, const Polygons& b) { return combined(Operation::union_, a, b); },
          nb::is_operator())
      .def(
          "__and__", [](const Polygons& a, const Polygons& b) { return combined(Operation::intersection, a, b); },
          nb::is_operator())
      .def(
          "__sub__", [](const Polygons& a, const Polygons& b) { return combined(Operation::difference, a, b); },
          nb::is_operator())
      .def(
          "__xor__",
          [](const Polygons& a, const Polygons& b) { return combined(Operation::symmetric_difference, a, b); },
          nb::is_operator())
      .def(
          "__eq__",
          [](const Polygons& a, const Polygons& b) {
            return run([&] { return canonical_form(*a.region) == canonical_form(*b.region); });
          },
          nb::is_operator(), nb::sig("def __eq__(self, other: object, /) -> bool"))
      .def("__hash__",
           [](const Polygons& p) {
             return nb::cast<std::int64_t>(nb::module_::import_("builtins").attr("hash")(text_of(p, "wkt", true)));
           })
      .def("__bool__", [](const Polygons& p) { return !p.region->empty(); })
      .def("__len__", [](const Polygons& p) { return p.region->polygons(); })
      .def_prop_ro(
          "area", [](const Polygons& p) { return run([&] { return planar::area(*p.region); }); }, "The exact area.")
      .def_prop_ro("loops", exact_loops,
                   nb::sig("def loops(self) -> list[list[list[tuple[fractions.Fraction, fractions.Fraction]]]]"),
                   "Per polygon its outer loop and its holes, as points of Fractions.")
      .def_prop_ro("__geo_interface__", geo_interface, nb::sig("def __geo_interface__(self) -> dict[str, typing.Any]"),
                   "As a MultiPolygon of GeoJSON, in nearest doubles.")
      .def(
          "membership", [](const Polygons& p, nb::object point) { return membership(p, point); }, "point"_a,
          nb::sig("def membership(self, point: collections.abc.Sequence[Number]) -> int"),
          "1 for a point in the interior, 0 on the boundary, -1 outside. Exact.")
      .def("rounded", rounded, "to"_a = nb::str("float64"),
           R"(Coordinates on a grid, and simple polygons still: crossings that rounding makes are resolved.

Examples
--------
>>> from fractions import Fraction
>>> Polygons([[(0, 0), (Fraction(1, 3), 0), (0, 1)]]).rounded(Fraction(1, 8)).area
Fraction(3, 16)
)")
      .def(
          "__reduce__",
          [](const Polygons& p) {
            return nb::make_tuple(nb::module_::import_("strata_csg._pickle").attr("polygons"),
                                  nb::make_tuple(text_of(p, "wkt", true)));
          },
          nb::sig("def __reduce__(self) -> tuple[typing.Any, ...]"))
      .def("__repr__", [](const Polygons& p) {
        return "Polygons(" + std::to_string(p.region->polygons()) + " with " +
               std::to_string(p.region->loops.vertices.size()) + " vertices)";
      });
}

}  // namespace

void bind_planar(nb::module_& m) {
  bind_polygons(m);
  m.def(
      "section",
      [](const Solid& solid, const PlanePair& plane) {
        const Plane p = plane.value();
        return run({}, [&](const Computation& c) { return shared(section(solid, p, c.options())); });
      },
      "solid"_a, "plane"_a, R"(The section of a solid by a plane (normal, offset), as polygons. Exact.

Coordinates are those of space without the axis along which the normal is longest; they turn counter-clockwise as seen
from in front of the plane: for the normal (0, 0, 1) they are x, y; for (0, 0, -1) y, x; for (0, 1, 0) z, x. Faces in
the plane belong to the section where the solid is in front of them.

Examples
--------
>>> section(box((0, 0, 0), (1, 2, 3)), ((0, 0, 1), 1)).area
Fraction(2, 1)
)");
  m.def("slice", sliced, "solid"_a, "axis"_a, "at"_a, nb::kw_only(), STRATA_WATCH_ARGUMENTS,
        R"(The sections by planes perpendicular to an axis (0, 1, 2), at doubles that do not decrease. Exact.

Coordinates of the polygons are y, z for axis 0; z, x for axis 1; x, y for axis 2. See `section`. A solid that was taken
at its word (``input='solid'``) and crosses or touches itself has loops that do.

Examples
--------
>>> [layer.area for layer in slice(box((0, 0, 0), (1, 2, 3)), 2, [0, 1, 2, 3])]
[Fraction(2, 1), Fraction(2, 1), Fraction(2, 1), Fraction(0, 1)]
)");
}

}  // namespace strata::python
