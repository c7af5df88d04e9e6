#pragma once
#include <cstdint>
#include <vector>

#include "extensions/scene/painters_order.h"
#include "extensions/scene/pieces.h"
#include "extensions/scene/signed_covering.h"
#include "strata/query.h"

namespace strata {

struct LayerDecomposition::Data {
  Data(Scene scene, const Origin& origin, const Monitor& monitor);

  SignedCovering covering;
  Pieces pieces;
  LayerOrder order;
  std::vector<std::uint32_t> sorted, first;  ///< pieces by layer; where each layer begins
  std::uint64_t pairs_tested = 0;
};

/// The signed covering about the origin of the layers.
[[nodiscard]] inline const SignedCovering& covering_of(const LayerDecomposition& layers) {
  return layers.data().covering;
}

/// The contents of the layers: the faces and the parts into which they were cut.
[[nodiscard]] inline const Pieces& pieces_of(const LayerDecomposition& layers) { return layers.data().pieces; }

}  // namespace strata
