#pragma once
#include <cstdint>
#include <string_view>

namespace strata::openscad {

enum class NodeKind : std::uint8_t {
  cube,
  sphere,
  cylinder,
  polyhedron,
  multmatrix,
  union_,    ///< union, group
  decorate,  ///< color, render: a union of its children
  difference,
  intersection,
  flat,   ///< a planar shape, or a node that makes a solid of one
  file,   ///< reads another file
  other,  ///< operations on solids that are no Booleans
  unknown
};

[[nodiscard]] NodeKind kind_of(std::string_view name);

/// The reason why a node of that kind is refused; null if it is supported.
[[nodiscard]] const char* refusal(NodeKind kind);

}  // namespace strata::openscad
