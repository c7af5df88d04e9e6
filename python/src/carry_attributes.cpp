#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <strata/carry_attributes.h>

#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "module.h"
#include "names.h"
#include "numpy.h"
#include "run.h"
#include "text.h"

namespace strata::python {

namespace {

using namespace nb::literals;

/// A pair of arrays, or the sources that a result has.
std::vector<Source> sources_from(nb::handle pair, nb::handle result) {
  nb::object operands, faces;
  if (!pair.is_none()) {
    if (!nb::isinstance<nb::tuple>(pair) || nb::len(pair) != 2)
      throw_type_error("sources: expected a pair (operands, faces) of arrays, found " + type_of(pair));
    operands = nb::object(pair[0]), faces = nb::object(pair[1]);
  } else {
    operands = nb::getattr(result, "source_operands", nb::none());
    faces = nb::getattr(result, "source_faces", nb::none());
    if (operands.is_none() || faces.is_none())
      throw_value_error("sources: expected a pair (operands, faces) of arrays, as the result knows none itself");
  }
  const auto column = [](nb::handle numbers) { return indices_of(array_from(numbers, "sources", "(n,)"), "sources"); };
  return sources_of(column(operands), column(faces));
}

Attributes carried(const MeshList& meshes, const MeshLike& argument, nb::object pair,
                   const MaterialOption& cut_material, const CutFacesName& cut_faces, unsigned threads,
                   ProgressOption progress, std::optional<double> timeout) {
  std::vector<MeshHandle> kept;
  for (const nb::handle member : meshes.object) {
    const std::string role = "operand " + std::to_string(kept.size());
    kept.push_back(copy_of(MeshLike{nb::borrow(member)}.value(role.c_str())));
  }
  const MeshHandle result = copy_of(argument.value("result"));
  const std::vector<Source> sources = sources_from(pair, argument.object);
  const CutFaces faces = cut_faces.value();
  std::vector<AttributedMesh> operands;
  for (const MeshHandle& mesh : kept) operands.push_back({mesh->exact_view(), mesh->attributes.get()});
  return run({threads, std::move(progress), timeout, cut_material.value("cut_material")}, [&](const Computation& c) {
    return carry_attributes(operands, result->exact_view(), sources, c.options(), faces);
  });
}

}  // namespace

void bind_carry_attributes(nb::module_& m) {
  m.def("carry_attributes", carried, "operands"_a, "result"_a, "sources"_a = nb::none(), nb::kw_only(),
        "cut_material"_a = nb::none(), "cut_faces"_a = nb::str("turned"), STRATA_WATCH_ARGUMENTS,
        nb::sig("def carry_attributes(operands: collections.abc.Iterable[MeshLike], result: MeshLike, "
                "sources: tuple[numpy.typing.ArrayLike, numpy.typing.ArrayLike] | None = None, *, "
                "cut_material: Material | None = None, "
                "cut_faces: typing.Literal['turned', 'of-later-operands'] = 'turned', threads: int = 0, "
                "progress: Progress = None, timeout: float | None = None) -> Attributes"),
        R"(What a mesh carries on from those whose faces its triangles are parts of.

`boolean`, `resolve`, and all functions from solids to solids do it themselves, but for `minkowski_sum`,
`erosion`, `offset` and `convex_hull`. The meshes of Layers carry nothing; this gives what they would.

Parameters
----------
operands : iterable of meshes
    As for `boolean`, with attributes.
result : mesh
    Every triangle of it lies in one triangle of an operand; where it does not, the nearest points speak.
sources : pair of arrays of integers, optional
    Per triangle of the result, the operand and its triangle. Without: the `source_operands` and `source_faces` of the
    result.
cut_material : Material, optional
    What cut faces are made of that have no material.
cut_faces : {"turned", "of-later-operands"}
    Which those are: faces that are turned over, or those of all operands but the first.
threads, progress, timeout
    As for Solid.

Returns
-------
Attributes
    For ``Solid.with_attributes``, or for ``Mesh(..., attributes=...)``. Values are rounded once; those at corners of
    the operands are theirs, bit by bit.

Raises
------
InputError
    For indices out of range and coordinates that are not finite.
ValueError
    For sources of no triangle, and another number of them than of triangles.

Examples
--------
>>> sheet = Mesh([[-8, -8, .5], [8, -8, .5], [0, 8, .5]], [[0, 1, 2]], attributes=Attributes(vertex={"x": [-8., 8., 0.]}))
>>> inside = clip(sheet, box((0, 0, 0), (1, 1, 1)))
>>> attributes = carry_attributes([sheet], inside)
>>> bool((attributes["x"] == inside.vertices[:, 0]).all())
True
)");
}

}  // namespace strata::python
