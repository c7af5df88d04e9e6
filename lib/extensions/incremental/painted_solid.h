#pragma once
#include <cstdint>
#include <memory>

#include "strata/solid.h"

namespace strata {

/// A solid with attributes that an incremental solid was made of, or combined with.
struct PaintedSolid {
  Solid solid;
  std::uint64_t number = 0;  ///< in the order in which solids were given
};
using PaintedSolidPointer = std::shared_ptr<const PaintedSolid>;

/// Null for a solid without attributes.
[[nodiscard]] inline PaintedSolidPointer painted(const Solid& solid, std::uint64_t number) {
  return solid.attributes().empty() ? nullptr : std::make_shared<const PaintedSolid>(PaintedSolid{solid, number});
}

}  // namespace strata
