#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <strata/io.h>

#include "arrays.h"
#include "module.h"
#include "run.h"

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

MeshHandle read(nb::object path, const std::optional<std::string>& format) {
  const std::string name = path_of(path);
  const std::optional<Format> kind = format_of_name(format);
  MeshFile file = run([&] { return read_mesh(name, kind); });
  return mesh_of(ExactMesh{std::move(file.mesh), std::move(file.exact)});
}

MeshHandle read_bytes(const nb::bytes& data, const std::string& format) {
  const std::string_view bytes(data.c_str(), data.size());
  const Format kind = *format_of_name(format);
  MeshFile file = run([&] { return read_mesh(bytes, kind, "data." + format); });
  return mesh_of(ExactMesh{std::move(file.mesh), std::move(file.exact)});
}

std::vector<std::string> write(nb::object path, const MeshLike& argument, const std::optional<std::string>& format) {
  const std::string name = path_of(path);
  const ExactMesh mesh = argument.value()->copy();
  const std::optional<Format> kind = format_of_name(format);
  return run([&] { return write_mesh(name, mesh, kind); });
}

nb::bytes write_bytes(const MeshLike& argument, const std::string& format) {
  const ExactMesh mesh = argument.value()->copy();
  const Format kind = *format_of_name(format);
  const std::string text = run([&] { return to_string(mesh, kind); });
  return nb::bytes(text.data(), text.size());
}

}  // namespace

void bind_files(nb::module_& m) {
  m.def("read", read, "path"_a, "format"_a = nb::none(),
        nb::sig("def read(path: str | os.PathLike[str], format: str | None = None) -> Mesh"),
        R"(Reads a mesh: STL, OBJ, OFF, PLY, and XOFF, which keeps fractions; others where the build has assimp.

Coordinates are the numbers in the file. What is read need not bound a solid: `check` and Solid tell.

Parameters
----------
path : str or path
format : str, optional
    "stl", "stl-ascii", "obj", "off", "xoff", "ply", "ply-ascii"; without: by the extension.

Raises
------
FileError
    A file that is missing, or not what its format demands; an OSError.

Examples
--------
>>> import os, tempfile
>>> path = os.path.join(tempfile.mkdtemp(), "part.off")
>>> write(path, box((0, 0, 0), (1, 1, 1)))
[]
>>> read(path)
Mesh(8 vertices, 12 triangles)
)");
  m.def("write", write, "path"_a, "mesh"_a, "format"_a = nb::none(),
        nb::sig("def write(path: str | os.PathLike[str], mesh: MeshLike, format: str | None = None) -> list[str]"),
        R"(Writes a mesh, the format by the extension. The file is complete, or not there.

Text and PLY keep every double, XOFF fractions; binary STL rounds to floats.

Returns
-------
list of str
    What did not survive, a sentence each.

Raises
------
FileError
    A file that cannot be written; an OSError.

Examples
--------
>>> import os, tempfile
>>> write(os.path.join(tempfile.mkdtemp(), "part.stl"), box((0, 0, 0), (1, 1, 1)))
[]
)");
  m.def("read_bytes", read_bytes, "data"_a, "format"_a, R"(Reads a mesh from bytes in memory.

Examples
--------
>>> read_bytes(write_bytes(box((0, 0, 0), (1, 1, 1)), "ply"), "ply")
Mesh(8 vertices, 12 triangles)
)");
  m.def("write_bytes", write_bytes, "mesh"_a, "format"_a, R"(The bytes that `write` would write.

Examples
--------
>>> write_bytes(tetrahedron((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)), "off").split(b"\n")[1]
b'4 4 0'
)");
}

}  // namespace strata::python
