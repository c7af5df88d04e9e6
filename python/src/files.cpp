#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <strata/io.h>

#include "arrays.h"
#include "module.h"
#include "names.h"
#include "run.h"
#include "text.h"

namespace strata::python {

/// "all" for those of the mesh, Attributes, or None.
struct AttributesChoice {
  nb::object object;
  [[nodiscard]] AttributesHandle value(const ArrayMesh& mesh) const {
    if (nb::isinstance<nb::str>(object)) {
      if (encoded(object, "attributes") == "all") return mesh.attributes;
      throw_value_error("attributes: expected \"all\", Attributes or None, found '" + text_of(object) + "'");
    }
    return AttributesOption{object}.value();
  }
};

}  // namespace strata::python

namespace nanobind::detail {

STRATA_ARGUMENT(strata::python::AttributesChoice, "Attributes | typing.Literal['all'] | None");

}  // namespace nanobind::detail

namespace strata::python {

namespace {

using namespace nb::literals;

std::optional<Format> format_of_name(const std::optional<std::string>& name) {
  if (!name) return std::nullopt;
  const std::optional<Format> format = format_named(*name);
  if (!format) throw std::invalid_argument("format: there is none of the name '" + *name + "'");
  return format;
}

/// The path of a str or an os.PathLike, in the encoding of the file system.
std::string path_of(nb::handle path) {
  const nb::object encoded = nb::module_::import_("os").attr("fsencode")(path);
  return {PyBytes_AsString(encoded.ptr()), static_cast<std::size_t>(PyBytes_Size(encoded.ptr()))};
}

MeshHandle mesh_in(MeshFile file) {
  const NewMesh mesh = mesh_of(ExactMesh{std::move(file.mesh), std::move(file.exact)});
  mesh->attributes = handle_of(std::move(file.attributes));
  mesh->unit = file.unit;
  nb::list notes;
  for (const std::string& note : file.notes) notes.append(decoded(note));
  mesh->file_notes = nb::tuple(notes);
  return mesh;
}

MeshHandle read(nb::object path, const std::optional<std::string>& format) {
  const std::string name = path_of(path);
  const std::optional<Format> kind = format_of_name(format);
  return mesh_in(run([&] { return read_mesh(name, kind); }));
}

MeshHandle read_bytes(const nb::bytes& data, const std::string& format) {
  const std::string_view bytes(data.c_str(), data.size());
  const Format kind = *format_of_name(format);
  return mesh_in(run([&] { return read_mesh(bytes, kind, "data." + format); }));
}

/// What is written: a mesh, its attributes or others, its unit or another one.
class Written {
 public:
  Written(const MeshLike& mesh, const AttributesChoice& attributes, const UnitName& unit)
      : mesh_(mesh.value()),
        attributes_(attributes.value(*mesh_)),
        unit_(unit.object.is_none() ? mesh_->unit : unit.value()) {}

  /// To a file. Indices are copied, for another thread may change arrays of NumPy after they were checked.
  [[nodiscard]] std::vector<std::string> write(const std::string& path, std::optional<Format> format,
                                               bool strict) const {
    const WriteOptions chosen = options(format, strict);
    if (!mesh_->owned.exact.empty()) return write_mesh(path, mesh_->copy(), chosen);
    const std::span<const Triangle> given = mesh_->view.triangles;
    const std::vector<Triangle> triangles(given.begin(), given.end());
    return write_mesh(path, MeshView{mesh_->view.vertices, triangles}, chosen);
  }
  [[nodiscard]] std::string text(std::optional<Format> format, bool strict) const {
    return to_string(mesh_->copy(), options(format, strict));
  }

 private:
  [[nodiscard]] WriteOptions options(std::optional<Format> format, bool strict) const {
    return {.format = format, .attributes = attributes_.get(), .unit = unit_, .strict = strict};
  }

  MeshHandle mesh_;
  AttributesHandle attributes_;
  Unit unit_;
};

nb::list write(nb::object path, const MeshLike& mesh, const std::optional<std::string>& format,
               const AttributesChoice& attributes, const UnitName& unit, bool strict) {
  const std::string name = path_of(path);
  const Written written(mesh, attributes, unit);
  const std::optional<Format> kind = format_of_name(format);
  nb::list notes;
  for (const std::string& note : run([&] { return written.write(name, kind, strict); })) notes.append(decoded(note));
  return notes;
}

nb::bytes write_bytes(const MeshLike& mesh, const std::string& format, const AttributesChoice& attributes,
                      const UnitName& unit, bool strict) {
  const Written written(mesh, attributes, unit);
  const std::optional<Format> kind = format_of_name(format);
  const std::string text = run([&] { return written.text(kind, strict); });
  return nb::bytes(text.data(), text.size());
}

nb::list formats() {
  nb::list records;
  for (int k = 0; static_cast<Format>(k) != Format::other; ++k) {
    const auto format = static_cast<Format>(k);
    nb::dict record;
    record["name"] = std::string(name(format));
    record["reads"] = can_read(format);
    record["writes"] = can_write(format);
    record["floats"] = holds_floats(format);
    records.append(record);
  }
  return records;
}

}  // namespace

void bind_files(nb::module_& m) {
  m.def("read", read, "path"_a, "format"_a = nb::none(),
        nb::sig("def read(path: str | os.PathLike[str], format: str | None = None) -> Mesh"),
        R"(Reads a mesh, with what the format has beside the shape; `formats` lists the formats.

Coordinates are the numbers in the file. What is read need not bound a solid: `check` and Solid tell.

Parameters
----------
path : str or path
format : str, optional
    "stl", "stl-ascii", "obj", "off", "xoff", "ply", "ply-ascii", "ply-big-endian", "3mf", "glb", "gltf", "amf", or
    another extension where the build has assimp; without: by the extension of the path.

Returns
-------
Mesh
    Its `attributes` are the colours, texture coordinates, normals, materials, images and names of the file, `unit` is
    that of the file, and `file_notes` tell what was left out or decided.

Raises
------
FileError
    A file that is missing, or not what its format demands; an OSError.

Examples
--------
>>> import os, tempfile
>>> path = os.path.join(tempfile.mkdtemp(), "part.3mf")
>>> red = Attributes(face={"material": [0] * 12}, materials=[Material("paint", color=(1, 0, 0))])
>>> write(path, box((0, 0, 0), (1, 1, 1)).with_attributes(red), unit="mm")
[]
>>> mesh = read(path)
>>> mesh.unit, mesh.attributes.materials[0].name
('millimeter', 'paint')
)");
  m.def("write", write, "path"_a, "mesh"_a, "format"_a = nb::none(), nb::kw_only(),
        "attributes"_a.none() = nb::str("all"), "unit"_a = nb::none(), "strict"_a = false,
        nb::sig("def write(path: str | os.PathLike[str], mesh: MeshLike, format: str | None = None, *, "
                "attributes: Attributes | typing.Literal['all'] | None = 'all', unit: str | None = None, "
                "strict: bool = False) -> list[str]"),
        R"(Writes a mesh, the format by the extension. The file is complete, or not there.

Text and PLY keep every double, XOFF fractions; binary STL and glTF round to floats. The material library and the images
of OBJ are files beside it.

Parameters
----------
path : str or path
mesh : mesh, as for `boolean`
format : str, optional
    As `formats` lists them; without: by the extension of the path.
attributes : "all", Attributes or None
    Those of the mesh, others, or nothing.
unit : str, optional
    Of coordinates, as for Mesh; without: that of the mesh. Nothing is converted.
strict : bool
    What would not survive is a FileError, and nothing is written.

Returns
-------
list of str
    What did not survive, a sentence each.

Raises
------
FileError
    A file that cannot be written; an OSError.
ValueError
    Attributes that do not fit the mesh, with the name of the channel; an unknown format or unit.

Examples
--------
>>> import os, tempfile
>>> hot = box((0, 0, 0), (1, 1, 1)).with_attributes(Attributes(face={"heat": range(12)}))
>>> folder = tempfile.mkdtemp()
>>> write(os.path.join(folder, "part.vtk"), hot)
[]
>>> len(write(os.path.join(folder, "part.stl"), hot))
1
)");
  m.def("read_bytes", read_bytes, "data"_a, "format"_a, R"(Reads a mesh from bytes in memory, as `read` does.

Examples
--------
>>> read_bytes(write_bytes(box((0, 0, 0), (1, 1, 1)), "ply"), "ply")
Mesh(8 vertices, 12 triangles)
)");
  m.def("write_bytes", write_bytes, "mesh"_a, "format"_a, nb::kw_only(), "attributes"_a.none() = nb::str("all"),
        "unit"_a = nb::none(), "strict"_a = false,
        nb::sig("def write_bytes(mesh: MeshLike, format: str, *, attributes: Attributes | typing.Literal['all'] | None "
                "= 'all', unit: str | None = None, strict: bool = False) -> bytes"),
        R"(The bytes that `write` would write; of OBJ, without the files beside it.

Examples
--------
>>> write_bytes(tetrahedron((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)), "off").split(b"\n")[1]
b'4 4 0'
)");
  m.def("formats", formats, nb::sig("def formats() -> list[dict[str, typing.Any]]"),
        R"(The formats of meshes, by name.

Returns
-------
list of dict
    ``name``; ``reads`` and ``writes``, whether that can be done; ``floats``, whether writing rounds to floats.

Examples
--------
>>> [format["name"] for format in formats() if format["writes"] and format["floats"]]
['stl', 'glb', 'gltf']
)");
}

}  // namespace strata::python
