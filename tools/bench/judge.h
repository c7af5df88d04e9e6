#pragma once
#include <cstddef>
#include <cstdint>

#include "strata/mesh.h"

namespace bench {

/// What can be said about any engine's result without asking the library.
struct Verdict {
  bool well_formed = false;  ///< indices in range, coordinates finite; the rest is meaningless otherwise
  bool closed = false;       ///< vertices with equal coordinates taken as one, the sides of all triangles cancel
  double volume = 0;         ///< signed
  std::size_t vertices = 0;
  std::size_t triangles = 0;
};

[[nodiscard]] Verdict judge(strata::MeshView mesh);

}  // namespace bench
