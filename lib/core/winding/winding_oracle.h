#pragma once
#include <cstdint>
#include <span>

#include "core/cells/windings.h"
#include "core/kernel/point.h"

namespace strata {

class CellTree;

/// Tells winding numbers at points of faces: from many local origins (LocalWindings) or from one for all
/// (CommonOrigin).
class WindingOracle {
 public:
  virtual ~WindingOracle() = default;

  /// Winding numbers about all operands but `own`, whose entry is left out, at a point of a face of `own`. Requires
  /// that the point is on no face of another operand.
  [[nodiscard]] virtual Windings around(const Point& q, std::uint32_t own) const = 0;

  /// Winding numbers about all operands just above `face` (on its outer side) at a point of it. `covering` are the
  /// faces coplanar with it that contain q, itself included; q is on no other face.
  [[nodiscard]] virtual Windings above(std::uint32_t face, const Point& q,
                                       std::span<const std::uint32_t> covering) const = 0;

  /// The cells whose origins know the winding numbers, or null.
  [[nodiscard]] virtual const CellTree* cells() const { return nullptr; }

 protected:
  WindingOracle() = default;
  WindingOracle(const WindingOracle&) = default;
  WindingOracle& operator=(const WindingOracle&) = default;
};

}  // namespace strata
