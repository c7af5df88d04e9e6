#include "core/mesh/prepare.h"

namespace strata {

Prepared prepare(ExactMeshView mesh, const Options& options, std::size_t operand) {
  if (!mesh.exact.empty()) return prepare_exact(mesh, operand);
  switch (options.input) {
    case InputClass::automatic:
    case InputClass::solid:
    case InputClass::overlapping:
      return prepare_closed(mesh.mesh, false, operand);
    case InputClass::repair:
      return prepare_soup(mesh.mesh, Holes::refused, operand);
    case InputClass::soup:
      return prepare_soup(mesh.mesh, Holes::filled, operand, options.most_hole_edges);
  }
  return {};
}

}  // namespace strata
