#pragma once
#include "core/kernel/input_complex.h"
#include "strata/mesh.h"

namespace strata::test {

/// One mesh that may cross itself, as input. Refers to the mesh.
inline InputComplex complex_of(const Mesh& mesh) {
  InputComplex complex(SelfIntersections::possible);
  complex.add(mesh.vertices, mesh.triangles);
  return complex;
}

}  // namespace strata::test
