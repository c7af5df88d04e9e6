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
      {"square", square},
      {"circle", circle},
      {"polygon", polygon},
      {"text", text},
      {"import", import},
      {"surface", surface},
      {"multmatrix", multmatrix},
      {"union", union_},
      {"group", union_},
      {"color", color},
      {"render", render},
      {"difference", difference},
      {"intersection", intersection},
      {"hull", hull},
      {"minkowski", minkowski},
      {"resize", resize},
      {"offset", offset},
      {"fill", fill},
      {"projection", projection},
      {"linear_extrude", linear_extrude},
      {"rotate_extrude", rotate_extrude},
      {"roof", roof},
  }};
  const auto* const found = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == name; });
  return found == kinds.end() ? unknown : found->second;
}

const char* refusal(NodeKind kind) {
  if (kind == NodeKind::roof) return "is not supported: straight skeletons are not computed";
  if (kind == NodeKind::unknown)
    return "is no node that OpenSCAD writes into .csg files ('openscad -o part.csg part.scad' makes one)";
  return nullptr;
}

}  // namespace strata::openscad
