#pragma once
/// Meshes between NumPy and the library.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <strata/combine.h>
#include <strata/mesh.h>
#include <strata/solid.h>
#include <strata/unit.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "attributes.h"
#include "numbers.h"

namespace strata::python {

/// What Python calls a Mesh: arrays of the caller, which are looked at, or arrays of the library, which it owns.
/// Immutable. Whatever it refers to lives as long as it does.
struct ArrayMesh {
  nb::object vertices, triangles;  ///< arrays of Python; none where `owned` has them
  ExactMesh owned;
  MeshView view;  ///< of one or the other
  AttributesHandle attributes;
  Unit unit = Unit::none;
  std::vector<Source> sources;
  bool has_sources = false;
  std::vector<std::pair<std::string, double>> seconds;  ///< per stage
  nb::object notes = nb::make_tuple(), file_notes = nb::make_tuple(), rounding = nb::none();

  ArrayMesh() = default;
  ArrayMesh(const ArrayMesh&) = delete;
  ArrayMesh& operator=(const ArrayMesh&) = delete;

  [[nodiscard]] ExactMeshView exact_view() const { return {view, owned.exact}; }
  [[nodiscard]] ExactMesh copy() const;
};

using MeshHandle = std::shared_ptr<const ArrayMesh>;
/// Of a mesh that is being made.
using NewMesh = std::shared_ptr<ArrayMesh>;

/// Of arrays of shapes (n, 3) and (m, 3), or of what NumPy makes such arrays of. Coordinates: floats of up to 64 bits,
/// integers that are doubles, or objects that are numbers, which are taken exactly. Indices: integers. C-contiguous
/// arrays of float64 and uint32 are looked at, others copied. Throws TypeError and ValueError that say what is wrong
/// with which array.
[[nodiscard]] NewMesh mesh_of_arrays(nb::handle vertices, nb::handle triangles);

/// Throws std::invalid_argument where they do not fit the mesh. Null: nothing.
void set_attributes(ArrayMesh& mesh, AttributesHandle attributes);

/// The solid that was made from a mesh, with what this carries.
[[nodiscard]] Solid with_attributes_of(const ArrayMesh& mesh, Solid solid, const Options& options);

/// A copy, which no other thread changes, for functions that read past arrays where indices are out of range. Throws
/// InputError for these, and for coordinates that are not finite. O(n).
[[nodiscard]] MeshHandle copy_of(const MeshHandle& mesh);

/// Adds a vertex to a mesh, and returns its number. Beyond all doubles its nearest doubles are infinite.
std::uint32_t add_vertex(ExactMesh& mesh, RationalPoint position);

/// A mesh that owns its arrays.
[[nodiscard]] NewMesh mesh_of(ExactMesh mesh);
[[nodiscard]] NewMesh mesh_of(BooleanResult result);

/// Anything that is a mesh in Python: a Mesh, a Solid or a Surface of this package; a pair of arrays; an object with
/// `vertices` and `triangles` or `faces`, such as those of trimesh.
struct MeshLike {
  nb::object object;
  [[nodiscard]] MeshHandle value(const char* role = "mesh") const;
};

/// What NumPy makes an array of.
struct ArrayLike {
  nb::object object;
};

/// An iterable of what are meshes.
struct MeshList {
  nb::object object;
};

/// Positions: an array (n, 3), or a mesh, whose vertices are meant. Points of objects are exact.
[[nodiscard]] MeshHandle points_of(nb::handle points, const char* role);

using DoubleRows = nb::ndarray<nb::numpy, const double, nb::shape<-1, 3>, nb::c_contig>;
using IndexRows = nb::ndarray<nb::numpy, const std::uint32_t, nb::shape<-1, 3>, nb::c_contig>;
using IndexColumn = nb::ndarray<nb::numpy, const std::uint32_t, nb::ndim<1>>;

/// Arrays over memory that `owner` keeps.
[[nodiscard]] DoubleRows rows_of(std::span<const Vertex> vertices, nb::handle owner);
[[nodiscard]] IndexRows rows_of(std::span<const Triangle> triangles, nb::handle owner);
[[nodiscard]] IndexColumn operands_of(std::span<const Source> sources, nb::handle owner);
[[nodiscard]] IndexColumn faces_of(std::span<const Source> sources, nb::handle owner);

/// The inverse of the two above. Throws ValueError for arrays of different lengths.
[[nodiscard]] std::vector<Source> sources_of(nb::handle operands, nb::handle faces);

/// An array of the library that becomes one of Python, without a copy.
template <class T>
[[nodiscard]] nb::ndarray<nb::numpy, T, nb::ndim<1>> column_of(std::vector<T> values) {
  auto* const kept = new std::vector<T>(std::move(values));
  const nb::capsule owner(kept, [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
  return nb::ndarray<nb::numpy, T, nb::ndim<1>>(kept->data(), {kept->size()}, owner);
}

/// All positions as an array of objects (n, 3) of Fractions.
[[nodiscard]] nb::object exact_rows(ExactMeshView mesh);
/// Numbers of the vertices that are not three doubles, and numerators and denominators of their positions (k, 3).
[[nodiscard]] nb::tuple exact_parts(std::span<const ExactVertex> exact);

}  // namespace strata::python

namespace nanobind::detail {

STRATA_ARGUMENT(strata::python::MeshLike, "MeshLike");
STRATA_ARGUMENT(strata::python::MeshList, "collections.abc.Iterable[MeshLike]");
STRATA_ARGUMENT(strata::python::ArrayLike, "numpy.typing.ArrayLike");

}  // namespace nanobind::detail
