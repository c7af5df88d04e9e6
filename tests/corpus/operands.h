#pragma once
#include <filesystem>
#include <string>

#include "strata/mesh.h"

namespace strata::test {

/// Two meshes of a case.
struct MeshPair {
  Mesh a;
  Mesh b;
};

/// A pair of the printed-object benchmark: the raw files under the affine maps of expected/ember_cases.csv, in doubles.
[[nodiscard]] MeshPair ember_pair(const std::filesystem::path& root, const std::string& number);

/// The mesh turned by two rotations through the angle of the 3-4-5 triangle and moved by a dyadic share of its size,
/// in doubles: close to itself, in no special position.
[[nodiscard]] Mesh rotated_copy(const Mesh& mesh);

}  // namespace strata::test
