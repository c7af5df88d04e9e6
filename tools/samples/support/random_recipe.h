#pragma once
#include "support/random.h"
#include "support/recipe.h"

namespace strata::test {

/// How large random recipes may be.
struct RecipeSize {
  std::size_t solids = 16;  ///< different ones, as numbers; some are copies of one another
  std::size_t leaves = 32;  ///< occurrences of solids
  std::size_t depth = 12;
  bool maps = true;  ///< results in between are mapped, too
};

/// A random affine map by thirds: scaled, mirrored or sheared, and moved. Grids of thirds go to such.
[[nodiscard]] Affine map_by_thirds(Random& random);

/// Solids that touch in faces, edges and vertices: on one lattice, or all of them through one point; copies of one
/// another as they are, listed otherwise, turned, or mapped by thirds.
[[nodiscard]] std::vector<ExactMesh> touching_family(Random& random, std::size_t count);

/// A random expression about the solids, all six kinds of steps; bounded. Subexpressions may occur several times.
[[nodiscard]] Recipe random_recipe(Random& random, std::vector<ExactMesh> solids, const RecipeSize& size);

/// Both: an expression about touching solids. The same seed gives the same one on every machine.
[[nodiscard]] Recipe touching_recipe(std::uint64_t seed, const RecipeSize& size);

}  // namespace strata::test
