#pragma once
#include <initializer_list>
#include <string>
#include <string_view>

#include "strata/mesh.h"

namespace strata::test {

/// The mesh as OFF text; numbers are the shortest that read back to the same doubles.
[[nodiscard]] std::string off_text(const Mesh& mesh);

/// A mesh from lines "v x y z" and "f i j k" (from 0); lines may be parted by semicolons.
/// Throws std::invalid_argument for anything else.
[[nodiscard]] Mesh mesh_from_text(std::string_view text);

/// Writes each mesh as <stem>-<number>.off in the working directory; returns the names, for a failure message.
std::string dump_off(std::string_view stem, std::initializer_list<const Mesh*> meshes);

}  // namespace strata::test
