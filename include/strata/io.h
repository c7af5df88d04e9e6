#pragma once
/// Mesh files: STL, OBJ, OFF, PLY, and XOFF, which keeps rational coordinates; glTF, 3MF and others by assimp.
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
  /// glTF, 3MF, FBX, DAE and whatever else assimp reads, into floats; cannot be written. Its readers run in a child
  /// process with limits of memory and time, and read other files only where they are beneath the folder of the model.
  other,
};

/// What a file holds. Coordinates are the numbers in the file, decimals as their nearest doubles: no units, no welding
/// by distance.
struct MeshFile {
  Mesh mesh;
  std::vector<std::string> notes;                  ///< what was left out or decided when reading, one sentence each
  std::vector<std::uint32_t> polygon_of_triangle;  ///< face of the file, from 0, per triangle; empty: they are the same
  std::vector<ExactVertex> exact;                  ///< as in ExactMesh: vertices that are not three doubles (XOFF only)
  Attributes attributes;                           ///< what the file says beside the shape
};

/// The format that goes with a file name's extension, upper or lower case; `other` for those that Strata has no reader
/// of its own for.
[[nodiscard]] Format format_of(const FilePath& path);

/// The format of a name: "stl", "stl-ascii", "obj", "off", "xoff", "ply", "ply-ascii", "ply-big-endian"; any other
/// extension that can be read ("glb") is `other`. No value for unknown names.
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

/// Writes a mesh, the format by extension unless given. Text and PLY keep every double exactly (shortest digits that
/// read back the same); binary STL rounds to floats. Returns notes: what did not survive.
/// The file is written beside the target and renamed when complete: the target is never half written. A target that
/// is no regular file (a device, a pipe) is written in place. Same bytes for any number of threads.
/// Throws IoError: unwritable targets, full disks, formats that cannot be written, coordinates that are not finite or
/// too large for the format, indices out of range.
std::vector<std::string> write_mesh(const FilePath& path, MeshView mesh, std::optional<Format> format = {});
/// The same with exact positions, which XOFF keeps; other formats get the rounded ones, which a note says. Throws
/// IoError also for exact positions that are not in order, of no vertex, or beyond the range of doubles.
std::vector<std::string> write_mesh(const FilePath& path, const ExactMesh& mesh, std::optional<Format> format = {});

/// The same into a stream, which `name` stands for in messages. Throws IoError, too, when the stream fails.
std::vector<std::string> write_mesh(std::ostream& stream, MeshView mesh, Format format, std::string name = "output");
std::vector<std::string> write_mesh(std::ostream& stream, const ExactMesh& mesh, Format format,
                                    std::string name = "output");

/// The same as the bytes of the file. Throws IoError for what cannot be written in the format.
[[nodiscard]] std::string to_string(MeshView mesh, Format format);
[[nodiscard]] std::string to_string(const ExactMesh& mesh, Format format);

}  // namespace strata
