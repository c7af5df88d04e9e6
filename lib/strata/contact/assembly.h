#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "strata/contact/nearest.h"
#include "strata/contact/region.h"
#include "strata/contact/relation.h"
#include "strata/csg/solid.h"
#include "strata/mesh/monitor.h"

namespace strata::contact {

/// Two parts that are not apart, the lower number first.
struct RelatedPair {
  std::uint32_t a = 0, b = 0;
  Relation relation = Relation::apart;

  friend bool operator==(const RelatedPair&, const RelatedPair&) = default;
};

/// Solids that stand beside one another, and what is between them: interference, contacts, distances. Exact for all
/// finite doubles and for rational vertices, at any scale.
///
/// Requires solids: surfaces with winding numbers 0 and 1, which may touch themselves anywhere, but have no membranes:
/// faces that lie on one another with the solid on no side. Parts are numbered as given; the same solid may occur
/// several times, and then interferes with itself. An immutable value, cheap to copy, safe to ask from many threads.
class Assembly {
 public:
  /// O(vertices); trees of faces are made when they are first needed. Throws std::length_error (more than 2^32 - 2
  /// vertices or faces in all).
  explicit Assembly(std::span<const Solid> parts);

  [[nodiscard]] std::uint32_t size() const;
  [[nodiscard]] const Solid& part(std::uint32_t number) const;

  /// All pairs that are not apart, by increasing numbers; all others are. The same for any number of threads. Pairs
  /// whose boxes are apart cost nothing but a comparison. Throws Cancelled.
  [[nodiscard]] std::vector<RelatedPair> pairs(const Monitor& monitor = {}) const;

  /// Pairs of parts that may be apart by `reach` at most, as their boxes tell, by increasing numbers, the lower one
  /// first; those that are not apart are among them. Infinite reach: all pairs of parts that are not empty. Requires
  /// that `reach` is not negative.
  [[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> near_pairs(double reach) const;

  /// How two different parts lie to each other. Law: symmetric.
  [[nodiscard]] Relation relation(std::uint32_t a, std::uint32_t b) const;
  /// Where two parts touch. Requires that they do not interfere; nothing where they are apart.
  [[nodiscard]] ContactRegion contact_region(std::uint32_t a, std::uint32_t b) const;
  /// What two parts have in common, regularized: a solid with exact vertices; empty unless they interfere. Where it
  /// shows that one touches itself inside of faces, both are resolved first.
  [[nodiscard]] Solid overlap(std::uint32_t a, std::uint32_t b) const;
  /// The least distance of two parts that are apart, and where it is. Requires that neither is empty.
  [[nodiscard]] Nearest nearest(std::uint32_t a, std::uint32_t b) const;

 private:
  std::shared_ptr<const Parts> parts_;
};

}  // namespace strata::contact
