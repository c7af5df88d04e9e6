#include "core/mesh/prepare.h"

namespace strata {

Prepared prepare(ExactMeshView mesh, const Options& options, std::size_t operand) {
  const Monitor monitor(options.cancel);
  if (!mesh.exact.empty()) return prepare_exact(mesh, operand, monitor);
  switch (options.input) {
    case InputClass::automatic:
    case InputClass::solid:
    case InputClass::overlapping:
      return prepare_closed(mesh.mesh, false, operand, monitor);
    case InputClass::repair:
      return prepare_soup(mesh.mesh, Holes::refused, operand, std::numeric_limits<std::size_t>::max(), monitor);
    case InputClass::soup:
      return prepare_soup(mesh.mesh, Holes::filled, operand, options.most_hole_edges, monitor);
  }
  return {};
}

}  // namespace strata
