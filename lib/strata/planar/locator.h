#pragma once
#include <memory>

#include "strata/planar/region.h"
#include "strata/planar/strips.h"

namespace strata::plane {

/// Point-membership classification (source document, 4.1).
enum class Membership { in, on, out };

/// Answers where points are relative to a region. For the interior of a polyloop, take the region that it fills
/// (`fill`, by parity): its edges are those of the boundary L.b, not those that have the interior on both sides.
/// Holds a reference to the region. Queries are const and thread-safe.
class Locator {
 public:
  explicit Locator(const Region& region);

  /// Exact for all finite points. Counts the edges to the left, at a height just above the point: no ray meets a
  /// vertex. O(segments in a strip).
  [[nodiscard]] Membership locate(const PlanePoint& p) const;
  [[nodiscard]] Membership locate(const RationalPlacement& p) const;

 private:
  struct Query;
  [[nodiscard]] Membership locate(const Query& q) const;
  [[nodiscard]] Sign compare_height(std::uint32_t vertex, const Query& q) const;
  [[nodiscard]] Sign compare_x(std::uint32_t vertex, const Query& q) const;
  [[nodiscard]] Sign side(const Query& q, std::uint32_t edge) const;

  const Loops& loops_;
  std::vector<std::array<std::uint32_t, 2>> edges_;
  std::vector<Line> lines_;
  std::unique_ptr<const Strips> strips_;
};

}  // namespace strata::plane
