#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/io/writers.h"

namespace strata::io {

/// A part of a mesh that a writer writes as an object of its own.
struct ObjectFaces {
  std::string name;
  std::vector<std::uint32_t> faces;     ///< of the mesh, in order
  std::vector<std::uint32_t> vertices;  ///< of the mesh, in order
  std::vector<Triangle> triangles;      ///< the same faces, with indices into `vertices`
};

/// The values of a channel of integers on faces with one component; empty if there is no such channel.
[[nodiscard]] std::span<const std::int32_t> numbers_of(const Attributes& attributes, std::string_view channel);

/// The same where they are indices into a list: empty also if its list has no entries.
[[nodiscard]] std::span<const std::int32_t> indices_of(const Attributes& attributes, std::string_view channel);

/// The objects of a mesh as the channel "object" tells them; those without faces are left out. Empty unless there are
/// at least two and each is closed: every edge in it has as many faces on either side. O(n log n).
[[nodiscard]] std::vector<ObjectFaces> closed_objects(MeshView mesh, const Attributes& attributes);

/// The whole mesh as one, with all its vertices, and the object's name if there is only one.
[[nodiscard]] ObjectFaces one_object(MeshView mesh, const Attributes& attributes);

}  // namespace strata::io
