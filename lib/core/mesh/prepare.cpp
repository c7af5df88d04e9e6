#include "core/mesh/prepare.h"

namespace strata {

Prepared prepare(ExactMeshView mesh, InputClass input, std::size_t operand) {
  if (!mesh.exact.empty()) return prepare_exact(mesh, operand);
  switch (input) {
    case InputClass::automatic:
    case InputClass::solid:
    case InputClass::overlapping:
      return prepare_closed(mesh.mesh, false, operand);
    case InputClass::repair:
      return prepare_soup(mesh.mesh, Holes::refused, operand);
    case InputClass::soup:
      return prepare_soup(mesh.mesh, Holes::filled, operand);
  }
  return {};
}

}  // namespace strata
