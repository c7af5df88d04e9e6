#pragma once
/// Mesh files: STL, OBJ, OFF, PLY, XOFF, which keeps rational coordinates, 3MF, glTF; others by assimp. Channels of
/// numbers (colours, normals and so on), materials, images, names and units come along where the format has them.
///
/// Paths are a std::string, a literal or a std::filesystem::path (FilePath). All functions may be called from many
/// threads at once; two that write one file race for it, but each leaves a complete one.
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strata/attributes.h"
#include "strata/errors.h"
#include "strata/file_path.h"
#include "strata/mesh.h"
#include "strata/unit.h"

namespace strata {

/// File formats. Reading finds the variant of an STL or PLY file in the file itself; writing uses the one named.
enum class Format {
  stl,        ///< binary, coordinates are floats
  stl_ascii,  ///< text, coordinates are doubles
  obj,
  off,
  xoff,  ///< text, coordinates are exact: doubles, integers of any length and their quotients; xoff.md
  ply,   ///< binary, little endian, doubles
  ply_ascii,
  ply_big_endian,
  threemf,    ///< 3MF: an archive of text, coordinates are doubles; has units, materials and objects
  glb,        ///< glTF 2.0 in one file; coordinates are floats
  gltf,       ///< glTF 2.0 as JSON; written with all that belongs to it inside; coordinates are floats
  amf,        ///< text, as it is or in an archive; cannot be written
  vtk,        ///< legacy VTK, binary, doubles; cannot be read
  vtk_ascii,  ///< cannot be read
  msh,        ///< Gmsh 4.1, text, doubles; cannot be read
  /// FBX, DAE and whatever else assimp reads, into floats; cannot be written. Its readers run in a child process with
  /// limits of memory and time, and read other files only where they are beneath the folder of the model.
  other,
};

/// What a file holds. Coordinates are the numbers in the file, decimals as their nearest doubles: no units, no welding
/// by distance.
struct MeshFile {
  Mesh mesh;
  std::vector<std::string> notes;                  ///< what was left out or decided when reading, one sentence each
  std::vector<std::uint32_t> polygon_of_triangle;  ///< face of the file, from 0, per triangle; empty: they are the same
  std::vector<ExactVertex> exact;                  ///< as in ExactMesh: vertices that are not three doubles (XOFF only)
  Attributes attributes;                           ///< channels, materials, images and names that the file has
  Unit unit = Unit::none;                          ///< of coordinates, if the file says one
};

/// How a mesh is written, and what is written with it.
struct WriteOptions {
  std::optional<Format> format;            ///< none: by extension
  const Attributes* attributes = nullptr;  ///< of the mesh; null: none
  Unit unit = Unit::none;                  ///< of coordinates; formats that have units say it
  bool strict = false;                     ///< what would be noted is an IoError; nothing is written then
};

/// The format that goes with a file name's extension, upper or lower case; `other` for those that Strata has no reader
/// of its own for.
[[nodiscard]] Format format_of(const FilePath& path);

/// The format of a name: "stl", "stl-ascii", "obj", "off", "xoff", "ply", "ply-ascii", "ply-big-endian", "3mf", "glb",
/// "gltf", "amf", "vtk", "vtk-ascii", "msh"; any other extension that can be read ("dae") is `other`. No value for
/// unknown names.
[[nodiscard]] std::optional<Format> format_named(std::string_view name);
[[nodiscard]] std::string_view name(Format format);

/// Reads a mesh, the format by extension unless given. Polygons are triangulated without moving or dropping a vertex,
/// so that shared edges stay shared; those that are not planar in doubles are noted, but in XOFF, where they are
/// errors. STL corners with equal coordinates (-0 = 0) become one vertex, in order of first use. Faces with fewer than
/// three different vertices are left out and noted. Throws IoError: missing, unreadable, empty, truncated or malformed
/// files, coordinates that are not finite or beyond the range of doubles, indices out of range, unknown formats; of
/// several errors the first in the file. What is read need not bound a solid: see InputClass and `check`. O(size of the
/// file), plus O(k^2) at worst for a face of k corners (O(k log k) in XOFF), in parallel: on all cores, or within the
/// caller's TBB arena. The result does not depend on the number of threads. Source: lib/core/io/theory.md; of XOFF
/// lib/core/io/xoff.md.
[[nodiscard]] MeshFile read_mesh(const FilePath& path, std::optional<Format> format = {});

/// The same for bytes in memory. `name` stands for the path in messages; for `other` its extension picks the reader.
[[nodiscard]] MeshFile read_mesh(std::string_view data, Format format, std::string name);
[[nodiscard]] MeshFile read_mesh(std::span<const std::byte> data, Format format, std::string name);

/// False for `amf` and `other`.
[[nodiscard]] bool can_read(Format format);
[[nodiscard]] bool can_write(Format format);
/// True when the format holds floats: writing it rounds doubles.
[[nodiscard]] bool holds_floats(Format format);

/// Writes a mesh, the format by extension unless given. Text and PLY keep every double exactly (shortest digits that
/// read back the same); binary STL and glTF round to floats. Returns notes: what did not survive.
/// The file is written beside the target and renamed when complete: the target is never half written. A target that
/// is no regular file (a device, a pipe) is written in place. Same bytes for any number of threads.
/// Throws IoError: unwritable targets, full disks, formats that cannot be written, coordinates that are not finite or
/// too large for the format, indices out of range.
std::vector<std::string> write_mesh(const FilePath& path, MeshView mesh, std::optional<Format> format = {});
/// The same with exact positions, which XOFF keeps; other formats get the rounded ones, which a note says. Throws
/// IoError also for exact positions that are not in order, of no vertex, or beyond the range of doubles.
std::vector<std::string> write_mesh(const FilePath& path, const ExactMesh& mesh, std::optional<Format> format = {});

/// The same with attributes and a unit. A note tells each kind of loss: PLY keeps every channel, VTK those on vertices
/// and faces, others those that they know (lib/core/io/theory.md). Of part.obj, the library part.mtl and images such as
/// part-wood.png are files beside it. They replace files as the target does, when all are complete. Throws
/// std::invalid_argument where attributes do not fit the mesh, as check_attributes says.
std::vector<std::string> write_mesh(const FilePath& path, MeshView mesh, const WriteOptions& options);
std::vector<std::string> write_mesh(const FilePath& path, const ExactMesh& mesh, const WriteOptions& options);

/// The same into a stream, which `name` stands for in messages. Throws IoError, too, when the stream fails.
std::vector<std::string> write_mesh(std::ostream& stream, MeshView mesh, Format format, std::string name = "output");
std::vector<std::string> write_mesh(std::ostream& stream, const ExactMesh& mesh, Format format,
                                    std::string name = "output");
/// Requires that the options have a format.
std::vector<std::string> write_mesh(std::ostream& stream, const ExactMesh& mesh, const WriteOptions& options,
                                    std::string name = "output");

/// The same as the bytes of the file. Throws IoError for what cannot be written in the format.
[[nodiscard]] std::string to_string(MeshView mesh, Format format);
[[nodiscard]] std::string to_string(const ExactMesh& mesh, Format format);
[[nodiscard]] std::string to_string(const ExactMesh& mesh, const WriteOptions& options);

}  // namespace strata
