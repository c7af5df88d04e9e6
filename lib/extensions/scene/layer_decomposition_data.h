#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "extensions/scene/painters_order.h"
#include "extensions/scene/pieces.h"
#include "extensions/scene/signed_covering.h"
#include "strata/query.h"

namespace strata {

struct LayerDecomposition::Data {
  explicit Data(SignedCovering c) : covering(std::move(c)), pieces(covering.scene()) {}

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
