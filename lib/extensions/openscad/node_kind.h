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
  decorate,  ///< color, render: a union of what is in it
  difference,
  intersection,
  flat,   ///< a shape in the plane, or what makes a solid of one
  file,   ///< reads another file
  other,  ///< of solids, but in other words than Booleans
  unknown
};

[[nodiscard]] NodeKind kind_of(std::string_view name);

/// Why a node of that kind is refused; null for those that are not.
[[nodiscard]] const char* refusal(NodeKind kind);

}  // namespace strata::openscad
