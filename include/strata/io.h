#pragma once
/// Mesh files.
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strata/errors.h"
#include "strata/file_path.h"
#include "strata/mesh.h"

namespace strata {

/// File formats. Reading tells the variants of STL and PLY apart by itself; writing obeys.
enum class Format {
  stl,        ///< binary, coordinates are floats
  stl_ascii,  ///< text, coordinates are doubles
  obj,
  off,
  xoff,  ///< text, coordinates are exact: doubles, integers of any length and their quotients; xoff.md
  ply,   ///< binary, little endian, doubles
  ply_ascii,
  ply_big_endian,
  other,  ///< glTF, 3MF, FBX, DAE and whatever else assimp reads, into floats; cannot be written
};

/// What a file holds. Coordinates are what the file says: no units, no welding by distance.
struct MeshFile {
  Mesh mesh;
  std::vector<std::string> notes;                  ///< what was left out or decided on the way, one sentence each
  std::vector<std::uint32_t> polygon_of_triangle;  ///< face of the file, from 0, per triangle; empty: they are the same
  std::vector<ExactVertex> exact;                  ///< as in ExactMesh: vertices that are not three doubles (XOFF only)
};

/// The format that goes with a file name's extension, in any case; `other` for those that are not ours.
[[nodiscard]] Format format_of(const FilePath& path);

/// The format of a name: "stl", "stl-ascii", "obj", "off", "xoff", "ply", "ply-ascii", "ply-big-endian"; any other
/// extension that can be read ("glb") is `other`. Nothing for names that mean nothing.
[[nodiscard]] std::optional<Format> format_named(std::string_view name);
[[nodiscard]] std::string_view name(Format format);

/// Reads a mesh, the format by extension unless given.
/// Polygons are triangulated without moving or dropping a vertex, so that shared edges stay shared; those that are not
/// planar in doubles are noted, but in XOFF, where they are errors. STL corners with equal coordinates (-0 = 0) become
/// one vertex, in order of first use. Faces with fewer than three different vertices are left out and noted. Throws
/// IoError: missing, unreadable, empty, truncated or malformed files, coordinates that are not finite or beyond the
/// range of doubles, indices out of range, unknown formats; of several errors the first in the file. O(size of the
/// file), plus O(k^2) at worst for a face of k corners (O(k log k) in XOFF), on all threads of the calling arena. The
/// result does not depend on their number. Source: theory.md.
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
/// The same with exact places, which XOFF keeps; other formats get the rounded ones. Throws IoError also for exact
/// places that are not in order, of no vertex, or beyond the range of doubles.
std::vector<std::string> write_mesh(const FilePath& path, const ExactMesh& mesh, std::optional<Format> format = {});

/// The same into a stream, to which `name` refers in messages. Checks the stream's state.
std::vector<std::string> write_mesh(std::ostream& stream, MeshView mesh, Format format, std::string name = "output");
std::vector<std::string> write_mesh(std::ostream& stream, const ExactMesh& mesh, Format format,
                                    std::string name = "output");

/// The same into memory.
[[nodiscard]] std::string to_string(MeshView mesh, Format format);
[[nodiscard]] std::string to_string(const ExactMesh& mesh, Format format);

}  // namespace strata
