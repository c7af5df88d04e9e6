#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "extensions/contact/parts.h"

namespace strata::contact {

/// Coincident faces of two parts: faces with the same three corners. Parts made to fit mostly touch in such faces. What
/// these share with their neighbours is known beforehand (theory.md, section 3).
class Twins {
 public:
  struct Pair {
    std::uint32_t f = 0, g = 0;  ///< of the first part, of the second
    bool look_the_same_way = false;
  };
  static constexpr std::uint32_t none = ~0u;

  /// Finds those whose corners are doubles. O(m log m) for m faces near the intersection of the parts' boxes.
  Twins(const Parts& parts, std::uint32_t a, std::uint32_t b);

  [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }

  /// True when the faces are coincident, or when doubles prove that they share only corners which one of them has in
  /// common with the coincident face of the other.
  [[nodiscard]] bool tell(std::uint32_t f, std::uint32_t g) const;

 private:
  [[nodiscard]] bool meet_in_corners(std::uint32_t part, std::uint32_t face, std::uint32_t other) const;

  const InputComplex& input_;
  std::array<std::uint32_t, 2> parts_;
  std::array<std::vector<std::uint32_t>, 2> partner_;  ///< per face of either part
  std::vector<Pair> pairs_;
};

}  // namespace strata::contact
