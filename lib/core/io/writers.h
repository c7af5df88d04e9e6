#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/io/sink.h"
#include "strata/mesh.h"

namespace strata::io {

/// Throws IoError for meshes that no format can represent or no reader would accept: coordinates that are not finite,
/// indices out of range.
void check_writable(MeshView mesh, const std::string& name);
/// The same for exact positions: of vertices that do not exist, not in order, or beyond the range of doubles.
void check_writable(std::span<const ExactVertex> exact, std::size_t vertex_count, const std::string& name);

/// One writer per format. A mesh without faces is written as some bytes, because readers refuse empty files. Requires
/// finite coordinates and indices in range.
void write_stl_ascii(MeshView mesh, Sink& sink);
void write_obj(MeshView mesh, Sink& sink);
void write_off(MeshView mesh, Sink& sink);
void write_xoff(MeshView mesh, std::span<const ExactVertex> exact, Sink& sink);
void write_ply_ascii(MeshView mesh, Sink& sink);
void write_ply_binary(MeshView mesh, Sink& sink, bool big_endian);

/// The header of a PLY file with doubles; `format` is its second word.
[[nodiscard]] std::string ply_header(MeshView mesh, const std::string& format);

/// Rounds coordinates to floats and reports this in a note. Throws IoError when one is beyond the range of floats or
/// there are more than 2^32 - 1 triangles.
[[nodiscard]] std::vector<std::string> write_stl(MeshView mesh, Sink& sink, const std::string& name);

}  // namespace strata::io
