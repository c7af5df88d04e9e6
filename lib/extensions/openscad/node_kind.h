#pragma once
#include <cstdint>
#include <string_view>

namespace strata::openscad {

enum class NodeKind : std::uint8_t {
  cube,
  sphere,
  cylinder,
  polyhedron,
  square,
  circle,
  polygon,
  text,
  import,
  surface,
  multmatrix,
  union_,  ///< union, group
  color,   ///< a union of its children
  render,  ///< a union of its children
  difference,
  intersection,
  hull,
  minkowski,
  resize,
  offset,
  fill,
  projection,
  linear_extrude,
  rotate_extrude,
  roof,
  unknown
};

[[nodiscard]] NodeKind kind_of(std::string_view name);

/// The reason why a node of that kind is refused; null if it is supported.
[[nodiscard]] const char* refusal(NodeKind kind);

}  // namespace strata::openscad
