#pragma once
#include "core/kernel/carriers.h"

namespace strata {

/// Where everything is seen from: a point, or infinitely far away, from where rays run along a direction.
struct Origin {
  enum class Kind { point, direction };

  Kind kind = Kind::point;
  Carriers::Coordinates at{};  ///< the point, or the direction of the rays (not zero, of any length)

  static Origin point(const Carriers::Coordinates& p) { return {Kind::point, p}; }
  static Origin direction(const Carriers::Coordinates& d) { return {Kind::direction, d}; }

  [[nodiscard]] bool is_point() const { return kind == Kind::point; }
  friend bool operator==(const Origin&, const Origin&) = default;
};

}  // namespace strata
