#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/io/files_beside.h"
#include "core/io/sink.h"
#include "strata/io.h"
#include "strata/mesh.h"

namespace strata::io {

/// Throws IoError for meshes that no format can represent or no reader would accept: coordinates that are not finite,
/// indices out of range.
void check_writable(MeshView mesh, const std::string& name);
/// The same for exact positions: of vertices that do not exist, not in order, or beyond the range of doubles.
void check_writable(std::span<const ExactVertex> exact, std::size_t vertex_count, const std::string& name);

using Notes = std::vector<std::string>;

/// What a writer writes, to what.
struct Target {
  MeshView mesh;
  std::span<const ExactVertex> exact;  ///< XOFF only
  const Attributes& attributes;
  Unit unit;
  Sink& sink;
  std::string name;               ///< of the file, for messages
  FilesBeside* beside = nullptr;  ///< null: no other files can stand beside it
};

/// One writer per format. A mesh without faces is written as some bytes, because readers refuse empty files. Requires
/// finite coordinates, indices in range, and attributes that fit (check_attributes). Returns notes: what was lost.
[[nodiscard]] Notes write_stl_ascii(const Target& target);
[[nodiscard]] Notes write_obj(const Target& target);
[[nodiscard]] Notes write_off(const Target& target);
[[nodiscard]] Notes write_xoff(const Target& target);
[[nodiscard]] Notes write_ply(const Target& target, Format format);
[[nodiscard]] Notes write_3mf(const Target& target);
[[nodiscard]] Notes write_glb(const Target& target);
[[nodiscard]] Notes write_gltf(const Target& target);
[[nodiscard]] Notes write_vtk(const Target& target, bool ascii);
[[nodiscard]] Notes write_msh(const Target& target);

/// Rounds coordinates to floats and reports this in a note. Throws IoError when one is beyond the range of floats or
/// there are more than 2^32 - 1 triangles.
[[nodiscard]] Notes write_stl(const Target& target);

/// Notes how many vertices a format of floats cannot represent. Throws IoError at coordinates beyond their range;
/// `format` names it in both.
[[nodiscard]] Notes note_floats(std::span<const Vertex> vertices, const std::string& name, const char* format);

}  // namespace strata::io
