#pragma once
#include <cstdint>
#include <vector>

#include "core/cells/windings.h"

namespace strata {

/// Where a point lies.
enum class Where : std::uint8_t { out, on, in };

/// A solid that a point lies on, and the lowest of its faces that it is on.
struct Contact {
  std::uint32_t solid = 0;
  std::uint32_t face = 0;  ///< of the scene

  friend bool operator==(const Contact&, const Contact&) = default;
};

/// Where a point lies in a scene.
struct Location {
  Windings windings;              ///< of the solids that the point is not on
  std::vector<Contact> contacts;  ///< the solids that it is on, in order

  /// A point at which these are the winding numbers, if it is off the surfaces, and which lies on `faces` of the scene.
  static Location of(Windings windings, std::vector<Contact> faces);

  /// With respect to all solids together: on a face of any; in: winding number about one of them not zero.
  [[nodiscard]] Where where() const {
    if (!contacts.empty()) return Where::on;
    return windings.begin() == windings.end() ? Where::out : Where::in;
  }
};

}  // namespace strata
