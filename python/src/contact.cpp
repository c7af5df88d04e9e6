#include "strata/contact.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <utility>
#include <vector>

#include "module.h"
#include "names.h"
#include "run.h"

namespace strata::python {

namespace {

using namespace nb::literals;
using contact::Assembly;

/// What Python is told of the region in which two parts touch.
struct Touch {
  std::vector<RationalPoint> points;
  std::vector<std::vector<std::vector<std::uint32_t>>> facets;  ///< by their loops
  std::vector<contact::ContactEdge> edges;
  std::vector<std::uint32_t> vertices;
  double area = 0, length = 0;
};

/// Takes a region apart. What is left over of it has many small parts, which are given back here: not while lists of
/// Python are made, where a signal would wait for them.
Touch touch_of(contact::ContactRegion region, const Monitor& monitor) {
  Touch touch;
  touch.area = region.area();
  touch.length = region.length();
  touch.facets.reserve(region.facets.size());
  for (contact::ContactFacet& facet : region.facets) {
    monitor.check();
    touch.facets.push_back(std::move(std::exchange(facet, {}).loops));
  }
  touch.points = std::move(region.points);
  touch.edges = std::move(region.edges);
  touch.vertices = std::move(region.vertices);
  return touch;
}

/// Two parts that are not apart, and where they meet.
struct Meeting {
  contact::RelatedPair pair;
  Solid overlap;  ///< where they interfere
  Touch touch;    ///< where they only touch
};

std::vector<Meeting> meetings_of(const std::vector<Solid>& parts, const Computation& computation) {
  const Assembly assembly(parts);
  Options options = computation.options();
  std::vector<Meeting> meetings;
  for (const contact::RelatedPair& pair : assembly.pairs(computation.monitor())) meetings.push_back({pair, {}, {}});
  options.progress = {};
  for (Meeting& m : meetings)
    if (m.pair.relation == contact::Relation::interfering)
      m.overlap = assembly.overlap(m.pair.a, m.pair.b, options);
    else
      m.touch = touch_of(assembly.contact_region(m.pair.a, m.pair.b, Monitor(options.cancel)), Monitor(options.cancel));
  return meetings;
}

nb::dict record_of(const Meeting& meeting) {
  nb::dict record;
  record["a"] = meeting.pair.a;
  record["b"] = meeting.pair.b;
  record["relation"] = contact::name(meeting.pair.relation);
  if (meeting.pair.relation == contact::Relation::interfering) {
    record["overlap"] = meeting.overlap;
    return record;
  }
  const Touch& touch = meeting.touch;
  nb::list points;
  for (const RationalPoint& p : touch.points) points.append(to_python(p));
  record["area"] = touch.area;
  record["length"] = touch.length;
  record["points"] = points;
  nb::list facets, edges, vertices;
  for (const auto& loops : touch.facets) facets.append(nb::cast(loops));
  for (const contact::ContactEdge& edge : touch.edges) edges.append(nb::make_tuple(edge.ends[0], edge.ends[1]));
  for (const std::uint32_t vertex : touch.vertices) vertices.append(vertex);
  record["facets"] = facets;
  record["edges"] = edges;
  record["vertices"] = vertices;
  return record;
}

nb::list contacts(const SolidList& parts, ProgressOption progress, std::optional<double> timeout) {
  const std::vector<Solid> solids = parts.value("parts");
  const std::vector<Meeting> meetings =
      run({0, std::move(progress), timeout}, [&](const Computation& c) { return meetings_of(solids, c); });
  nb::list records;
  for (const Meeting& meeting : meetings) records.append(record_of(meeting));
  return records;
}

/// Empty where the solids are not apart.
std::optional<contact::Nearest> nearest_points(const Solid& a, const Solid& b, const Computation& computation) {
  const Assembly assembly(std::array{a, b});
  const Monitor monitor = computation.monitor();
  if (assembly.relation(0, 1, monitor) != contact::Relation::apart) return std::nullopt;
  return assembly.nearest(0, 1, monitor);
}

nb::dict distance(const Solid& a, const Solid& b) {
  if (a.is_empty() || b.is_empty()) throw std::invalid_argument("distance: an empty solid has none");
  const auto nearest = run({}, [&](const Computation& c) { return nearest_points(a, b, c); });
  nb::dict record;
  record["distance"] = nearest ? nearest->distance : 0.0;
  record["squared"] = to_python(nearest ? nearest->squared : Rational(0));
  if (!nearest) return record;
  record["on_a"] = to_python(nearest->on_a);
  record["on_b"] = to_python(nearest->on_b);
  return record;
}

}  // namespace

void bind_contact(nb::module_& m) {
  m.def("contacts", contacts, "parts"_a, nb::kw_only(), "progress"_a = nb::none(), "timeout"_a = nb::none(),
        nb::sig(
            "def contacts(parts: collections.abc.Iterable[Solid], *, progress: Progress = None, timeout: float | None "
            "= None) -> list[dict[str, typing.Any]]"),
        R"(Which parts of an assembly interfere, and which touch, and where. Exact.

Parameters
----------
parts : iterable of Solid
progress, timeout
    As for Solid.

Returns
-------
list of dict
    One per pair that is not apart: ``a``, ``b`` (numbers), ``relation``: "contact" or "interfering". Interfering:
    ``overlap``, a Solid. Contact: ``points`` (tuples of Fractions), ``facets`` (loops of numbers of points), ``edges``
    and ``vertices`` that lie in no facet, ``area`` and ``length``.

Examples
--------
>>> pairs = contacts([box((0, 0, 0), (1, 1, 1)), box((1, 0, 0), (2, 1, 1)), box((1.5, 0, 0), (3, 1, 1))])
>>> [(pair["a"], pair["b"], pair["relation"]) for pair in pairs]
[(0, 1, 'contact'), (1, 2, 'interfering')]
>>> pairs[0]["area"], pairs[1]["overlap"].volume
(1.0, Fraction(1, 2))
)");
  m.def("distance", distance, "a"_a, "b"_a, nb::sig("def distance(a: Solid, b: Solid) -> dict[str, typing.Any]"),
        R"(The least distance of two solids and where it is. Exact.

Returns
-------
dict
    ``distance`` (float, within an ulp), ``squared`` (Fraction, exact); where they are apart also ``on_a`` and
    ``on_b``, a pair of closest points.

Raises
------
ValueError
    One of the solids is empty.

Examples
--------
>>> distance(box((0, 0, 0), (1, 1, 1)), box((2, 2, 0), (3, 3, 1)))["squared"]
Fraction(2, 1)
)");
}

}  // namespace strata::python
