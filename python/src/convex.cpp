#include "strata/convex.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "arrays.h"
#include "module.h"
#include "names.h"
#include "run.h"

namespace strata::python {

namespace {

using namespace nb::literals;

Solid hull_of(const ArrayLike& points, unsigned threads) {
  const MeshHandle mesh = points_of(points.object, "points");
  return run({threads, {}, {}}, [&](const Computation& c) {
    return convex::solid_of(convex::convex_hull(mesh->exact_view(), threads, c.monitor()));
  });
}

std::pair<Solid, double> grown(const Solid& solid, const Number& distance, std::uint32_t facets, unsigned threads,
                               ProgressOption progress, std::optional<double> timeout) {
  const double radius = distance.as_double("radius");
  convex::Offset offset = run({threads, std::move(progress), timeout},
                              [&](const Computation& c) { return convex::offset(solid, radius, facets, c.options()); });
  return {std::move(offset.solid), offset.excess};
}

/// The pieces of a decomposition as solids.
std::vector<Solid> pieces_of(const Solid& solid, const MaterialOption& cut_material, ProgressOption progress,
                             std::optional<double> timeout) {
  return run({1, std::move(progress), timeout, cut_material.value("cut_material")}, [&](const Computation& c) {
    const convex::Decomposition decomposition = convex::decompose(solid, c.monitor());
    if (c.options().cut_material != nullptr || !solid.attributes().empty())
      return convex::pieces_of(solid, decomposition, c.options());
    std::vector<Solid> pieces;
    for (std::uint32_t p = 0; p < decomposition.pieces.size(); ++p)
      pieces.push_back(convex::solid_of(decomposition.polytope(p)));
    return pieces;
  });
}

}  // namespace

void bind_convex(nb::module_& m) {
  m.def("convex_hull", hull_of, "points"_a, nb::kw_only(), "threads"_a = 0,
        nb::sig("def convex_hull(points: numpy.typing.ArrayLike | MeshLike, *, threads: int = 0) -> Solid"),
        R"(The convex hull of points, or of the vertices of a mesh, as a solid. Exact.

Points may be equal, collinear and coplanar. Of points in one plane the hull is empty: it has no volume.

Examples
--------
>>> convex_hull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [.1, .1, .1]])
Solid(4 vertices, 4 triangles)
)");
  m.def("decompose", pieces_of, "solid"_a, nb::kw_only(), "cut_material"_a = nb::none(), "progress"_a = nb::none(),
        "timeout"_a = nb::none(),
        R"(Convex solids with disjoint interiors whose union is the solid. Exact: volumes add up.

Pieces carry what the solid carries. Walls between them are made of `cut_material`, if it is given.

Examples
--------
>>> notched = box((0, 0, 0), (2, 2, 1)) - box((1, 1, 0), (2, 2, 1))
>>> pieces = decompose(notched)
>>> len(pieces), sum(piece.volume for piece in pieces)
(2, Fraction(3, 1))
)");
  m.def(
      "minkowski_sum",
      [](const Solid& a, const Solid& b, unsigned threads, ProgressOption progress, std::optional<double> timeout) {
        return run({threads, std::move(progress), timeout},
                   [&](const Computation& c) { return convex::minkowski_sum(a, b, c.options()); });
      },
      "a"_a, "b"_a, nb::kw_only(), STRATA_WATCH_ARGUMENTS,
      R"(All sums of a point of one solid and a point of the other. Exact.

Examples
--------
>>> minkowski_sum(box((0, 0, 0), (1, 1, 1)), box((0, 0, 0), (2, 3, 4))).volume
Fraction(60, 1)
)");
  m.def(
      "erosion",
      [](const Solid& a, const Solid& b, unsigned threads, ProgressOption progress, std::optional<double> timeout) {
        return run({threads, std::move(progress), timeout},
                   [&](const Computation& c) { return convex::erosion(a, b, c.options()); });
      },
      "a"_a, "b"_a, nb::kw_only(), STRATA_WATCH_ARGUMENTS, R"(All positions x such that b moved by x is within a. Exact.

Examples
--------
>>> erosion(box((0, 0, 0), (3, 3, 3)), box((0, 0, 0), (1, 1, 1))).volume
Fraction(8, 1)
)");
  m.def("offset", grown, "solid"_a, "radius"_a, nb::kw_only(), "facets"_a = 320, STRATA_WATCH_ARGUMENTS,
        R"(A solid grown, or shrunk by a negative radius, by a ball of facets.

Returns
-------
solid : Solid
excess : float
    The distance is between |radius| and (1 + excess) |radius| everywhere; proven.

Examples
--------
>>> grown, excess = offset(box((0, 0, 0), (1, 1, 1)), 0.5, facets=20)
>>> bool((grown.bounds[1] >= 1.5).all())
True
)");
}

}  // namespace strata::python
