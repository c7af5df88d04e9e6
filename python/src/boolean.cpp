#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <strata/combine.h>
#include <strata/resolve.h>
#include <strata/solid.h>

#include <algorithm>

#include "arrays.h"
#include "module.h"
#include "names.h"
#include "run.h"

namespace strata::python {

namespace {

using namespace nb::literals;

/// Operands, and what keeps their arrays.
struct Operands {
  std::vector<MeshHandle> kept;
  std::vector<Operand> views;
};

/// The unit of all operands that have one. Throws where they have several.
Unit common_unit(const Operands& operands) {
  const auto has_unit = [](const MeshHandle& mesh) { return mesh->unit != Unit::none; };
  const auto first = std::ranges::find_if(operands.kept, has_unit);
  if (first == operands.kept.end()) return Unit::none;
  const Unit unit = (*first)->unit;
  for (auto next = first; next != operands.kept.end(); ++next)
    if (has_unit(*next) && (*next)->unit != unit)
      throw std::invalid_argument("operand " + std::to_string(next - operands.kept.begin()) + ": its unit is " +
                                  std::string(name((*next)->unit)) + ", that of operand " +
                                  std::to_string(first - operands.kept.begin()) + " is " + std::string(name(unit)) +
                                  "; scale one of them");
  return unit;
}

Operands operands_of(const MeshList& meshes) {
  Operands operands;
  std::size_t number = 0;
  for (const nb::handle member : meshes.object) {
    const std::string role = "operand " + std::to_string(number++);
    const MeshHandle mesh = MeshLike{nb::borrow(member)}.value(role.c_str());
    operands.views.push_back({mesh->view, mesh->owned.exact, nb::isinstance<Solid>(member), mesh->attributes.get()});
    operands.kept.push_back(mesh);
  }
  return operands;
}

MeshHandle boolean(const OperationName& name, const MeshList& meshes, const InputName& input, bool exact,
                   const Grid& rounding, nb::object engine, std::optional<std::size_t> most_hole_edges,
                   const MaterialOption& cut_material, unsigned threads, ProgressOption progress,
                   std::optional<double> timeout) {
  const Operation operation = name.value();
  const Operands operands = operands_of(meshes);
  const Unit unit = common_unit(operands);
  const InputClass expected = input.value();
  const std::optional<CoordinateGrid> grid = rounding.value();
  const Engine* const other = engine_named(engine);
  if (exact && grid)
    throw std::invalid_argument("exact vertices are not rounded: expected exact or rounding, found both");
  const Watch watch{threads, std::move(progress), timeout, cut_material.value("cut_material")};
  const NewMesh result = mesh_of(run(watch, [&](const Computation& computation) {
    Options options = computation.options();
    options.input = expected;
    options.exact_vertices = exact;
    options.rounding = grid;
    options.engine = other;
    if (most_hole_edges) options.most_hole_edges = *most_hole_edges;
    return combine(operation, operands.views, options);
  }));
  result->unit = unit;
  return result;
}

template <Operation operation>
Solid combined(const SolidList& solids, const MaterialOption& cut_material, unsigned threads, ProgressOption progress,
               std::optional<double> timeout) {
  const std::vector<Solid> operands = solids.value();
  return run(
      {threads, std::move(progress), timeout, cut_material.value("cut_material")},
      [&](const Computation& computation) { return combine_solids(operation, operands, computation.options()); });
}

Solid resolved(const MeshLike& argument, const InsideName& inside, const InputName& input, unsigned threads,
               ProgressOption progress, std::optional<double> timeout) {
  const MeshHandle mesh = argument.value();
  const Inside kept = inside.value();
  const InputClass expected = input.value();
  return run({threads, std::move(progress), timeout}, [&](const Computation& computation) {
    Options options = computation.options();
    options.input = expected;
    return with_attributes_of(*mesh, resolve(mesh->copy(), kept, options), options);
  });
}

}  // namespace

void bind_boolean(nb::module_& m) {
  m.def("boolean", boolean, "operation"_a, "meshes"_a, nb::kw_only(), "input"_a = nb::str("automatic"),
        "exact"_a = false, "rounding"_a = nb::none(), "engine"_a = nb::none(), "most_hole_edges"_a = nb::none(),
        "cut_material"_a = nb::none(), STRATA_WATCH_ARGUMENTS,
        nb::sig("def boolean(operation: Operation, meshes: collections.abc.Iterable[MeshLike], *, input: InputClass = "
                "'automatic', exact: bool = False, rounding: Number | str | None = None, engine: "
                "typing.Literal['bsp', 'layers'] | None = None, most_hole_edges: int | None = None, "
                "cut_material: Material | None = None, threads: int = 0, progress: Progress = None, timeout: float | "
                "None = None) -> Mesh"),
        R"(The regularized Boolean of any number of meshes, from arrays to arrays.

The combinatorics are those of the exact result; coordinates of new vertices are the nearest doubles. Faces that meet
no other operand come out untouched. Arrays that are C-contiguous are not copied: no other thread, and no callback, may
write to them meanwhile.

Parameters
----------
operation : {"union", "intersection", "difference", "symmetric-difference"}
    Difference: the first mesh without all others. Also "xor".
meshes : iterable of meshes
    A Mesh, a Solid, a pair of arrays (vertices, triangles), or an object with `vertices` and `faces`.
input : {"automatic", "solid", "overlapping", "repair", "soup"}
    What is expected of the meshes; see Solid.
exact : bool
    Keep exact positions of vertices that are not doubles: `Mesh.exact_vertices`.
rounding : "float64", "float32" or a number, optional
    Round such that the mesh bounds a solid again, where nearest doubles would cross; see `Solid.rounded`.
engine : {"bsp", "layers"}, optional
    Compute it by another method, as a check. "bsp" carries no attributes.
cut_material : Material, optional
    What cut faces are made of; see `union`.
most_hole_edges, threads, progress, timeout
    As for Solid.

Returns
-------
Mesh
    With `source_operands`, `source_faces`, `notes`, `rounding` and `seconds`; with the `attributes` of the operands, and
    with the `unit` of those that have one.

Raises
------
InputError
    A mesh is not what was expected; `operand` says which.
ValueError
    Operands have different units, or attributes cannot be carried.

Examples
--------
>>> a, b = box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3))
>>> result = boolean("union", [a, (b.vertices, b.triangles)])
>>> sorted(set(result.source_operands.tolist()))
[0, 1]
>>> Solid(result).volume
Fraction(15, 1)
)");
  const auto define = [&m](const char* name, auto function, const char* text) {
    m.def(name, function, "solids"_a, nb::kw_only(), "cut_material"_a = nb::none(), STRATA_WATCH_ARGUMENTS, text);
  };
  define("union", combined<Operation::union_>, R"(The points in any of the solids, in one arrangement of all. Exact.

Parameters
----------
solids : iterable of Solid
cut_material : Material, optional
    What cut faces are made of where what cuts has no material. Of an intersection cut faces are those of all solids but
    the first, else those that are turned over: what is taken away.
threads, progress, timeout
    As for Solid.

Examples
--------
>>> union([box((i, 0, 0), (i + 2, 1, 1)) for i in range(10)]).volume
Fraction(11, 1)
)");
  define("intersection", combined<Operation::intersection>, R"(The points in all of the solids. Exact.

Examples
--------
>>> intersection([box((0, 0, 0), (2, 1, 1)), box((1, 0, 0), (3, 1, 1))]).volume
Fraction(1, 1)
)");
  define("difference", combined<Operation::difference>, R"(The points in the first solid and in no other. Exact.

Examples
--------
>>> paint = Material("paint", color=(0.8, 0, 0))
>>> cut = difference([box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3))], cut_material=paint)
>>> sorted(set(cut.attributes["material"].tolist())), cut.attributes.materials[0].name
([-1, 0], 'paint')
>>> difference([box((0, 0, 0), (3, 1, 1)), box((0, 0, 0), (1, 1, 1)), box((2, 0, 0), (3, 1, 1))]).volume
Fraction(1, 1)
)");
  define("symmetric_difference", combined<Operation::symmetric_difference>,
         R"(The points in an odd number of the solids. Exact.

Examples
--------
>>> symmetric_difference([box((0, 0, 0), (2, 1, 1)), box((1, 0, 0), (3, 1, 1))]).volume
Fraction(2, 1)
)");
  m.def("resolve", resolved, "mesh"_a, nb::kw_only(), "inside"_a = nb::str("winding"), "input"_a = nb::str("automatic"),
        STRATA_WATCH_ARGUMENTS, R"(A closed mesh that crosses and overlaps itself, made a solid. Exact.

Parameters
----------
mesh : mesh, as for `boolean`
inside : {"winding", "even-odd", "outer"}
    Inside is where the winding number is positive; where it is odd; all that the mesh closes off from infinity.
input : {"automatic", "solid", "overlapping", "repair", "soup"}
    What is accepted; "repair" and "soup": any triangles.
threads, progress, timeout
    As for Solid.

Examples
--------
>>> import numpy as np
>>> a, b = box((0, 0, 0), (2, 1, 1)), box((1, 0, 0), (3, 1, 1))
>>> both = Mesh(np.vstack([a.vertices, b.vertices]), np.vstack([a.triangles, b.triangles + 8]))
>>> resolve(both).volume
Fraction(3, 1)
>>> resolve(both, inside="even-odd").volume
Fraction(2, 1)
)");
}

}  // namespace strata::python
