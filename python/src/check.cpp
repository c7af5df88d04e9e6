#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <strata/check.h>
#include <strata/measure.h>

#include "arrays.h"
#include "errors.h"
#include "module.h"
#include "run.h"

namespace strata::python {

namespace {

using namespace nb::literals;

nb::tuple defects_of(const MeshLike& argument, std::size_t listed, unsigned threads, ProgressOption progress,
                     std::optional<double> timeout) {
  const MeshHandle mesh = argument.value();
  const std::vector<Defect> defects = run({threads, std::move(progress), timeout}, [&](const Computation& computation) {
    return check(mesh->exact_view(), computation.options(), listed);
  });
  return to_python(std::span(defects));
}

nb::dict measures_of(const MeshLike& argument, unsigned threads) {
  const MeshHandle held = copy_of(argument.value());
  const ExactMesh& mesh = held->owned;
  const Measures measures = run([&] { return measure(mesh, {.threads = threads}); });
  nb::dict facts;
  facts["volume"] = measures.volume;
  facts["area"] = measures.area;
  facts["facets"] = measures.facets;
  facts["components"] = measures.topology.components;
  facts["euler"] = measures.topology.euler;
  facts["non_manifold_edges"] = measures.topology.non_manifold_edges;
  facts["non_manifold_vertices"] = measures.topology.non_manifold_vertices;
  facts["open_edges"] = measures.topology.open_edges;
  return facts;
}

}  // namespace

void bind_check(nb::module_& m) {
  m.def("check", defects_of, "mesh"_a, nb::kw_only(), "listed"_a = few_defects, STRATA_WATCH_ARGUMENTS,
        nb::sig("def check(mesh: MeshLike, *, listed: int = 5, threads: int = 0, progress: Progress = None, timeout: "
                "float | None = None) -> tuple[Defect, ...]"),
        R"(Is a mesh the boundary of a solid? The complete, exact answer: all its defects.

Parameters
----------
mesh : mesh, as for `boolean`
listed : int
    So many defects of each kind are listed with place and faces; the others are counted.
threads, progress, timeout
    As for Solid.

Returns
-------
tuple of Defect
    Without one of severity "error" the mesh bounds a solid.

Examples
--------
>>> check(box((0, 0, 0), (1, 1, 1)))
()
>>> {defect.kind for defect in check(Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))}
{'open edge'}
)");
  m.def("measure", measures_of, "mesh"_a, nb::kw_only(), "threads"_a = 0,
        nb::sig("def measure(mesh: MeshLike, *, threads: int = 0) -> dict[str, int | float | None]"),
        R"(Volume, area and topology of a mesh, which need not be closed.

Returns
-------
dict
    ``volume``: the nearest double, None if the mesh is not closed; ``area``; ``facets``: sets of coplanar triangles
    that are connected; ``components``, ``euler``, ``non_manifold_edges``, ``non_manifold_vertices``, ``open_edges``.

Examples
--------
>>> facts = measure(box((0, 0, 0), (1, 1, 1)))
>>> facts["volume"], facts["facets"], facts["euler"]
(1.0, 6, 2)
)");
}

}  // namespace strata::python
