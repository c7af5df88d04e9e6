#include "extensions/openscad/node_kind.h"

#include <algorithm>
#include <array>
#include <utility>

namespace strata::openscad {

NodeKind kind_of(std::string_view name) {
  using enum NodeKind;
  static constexpr std::array<std::pair<std::string_view, NodeKind>, 26> kinds{{
      {"cube", cube},
      {"sphere", sphere},
      {"cylinder", cylinder},
      {"polyhedron", polyhedron},
      {"multmatrix", multmatrix},
      {"union", union_},
      {"group", union_},
      {"color", decorate},
      {"render", decorate},
      {"difference", difference},
      {"intersection", intersection},
      {"square", flat},
      {"circle", flat},
      {"polygon", flat},
      {"text", flat},
      {"offset", flat},
      {"fill", flat},
      {"projection", flat},
      {"linear_extrude", flat},
      {"rotate_extrude", flat},
      {"roof", flat},
      {"import", file},
      {"surface", file},
      {"hull", other},
      {"minkowski", other},
      {"resize", other},
  }};
  const auto* const found = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == name; });
  return found == kinds.end() ? unknown : found->second;
}

const char* refusal(NodeKind kind) {
  switch (kind) {
    case NodeKind::cube:
    case NodeKind::sphere:
    case NodeKind::cylinder:
    case NodeKind::polyhedron:
    case NodeKind::multmatrix:
    case NodeKind::union_:
    case NodeKind::decorate:
    case NodeKind::difference:
    case NodeKind::intersection:
      return nullptr;
    case NodeKind::flat:
      return "is not supported: no shapes in the plane, nor solids made of them";
    case NodeKind::file:
      return "is not supported: other files are not read";
    case NodeKind::other:
      return "is not supported: it is no Boolean operation";
    case NodeKind::unknown:
      return "is no node that OpenSCAD writes into .csg files ('openscad -o part.csg part.scad' makes one)";
  }
  return nullptr;
}

}  // namespace strata::openscad
