#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "extensions/scene/convex_cutting.h"
#include "extensions/scene/layer_decomposition.h"

namespace strata {

/// A stretch of an edge from a to b: all a + t (b - a) with from <= t <= to.
struct Stretch {
  Rational from, to;
};

/// What is seen of a scene of opaque faces from the origin of its decomposition, exactly.
///
/// A point inside a face is hidden when another face comes before it on its ray. A point of an edge is seen when points
/// of one of its faces that lie as near to it as one likes are seen; so edges that coincide as seen, as often happens
/// along axes, are hidden or not by what lies on their own side. Flat faces are not seen.
///
/// Faces that cross each other hide each other rightly. Safe to ask from many threads.
class Visibility {
 public:
  explicit Visibility(LayerDecomposition decomposition);

  [[nodiscard]] const LayerDecomposition& decomposition() const { return decomposition_; }

  /// The seen stretches of the edge from a to b, vertices of `face`, as its border; in order, without common points.
  /// O(k log k) for k faces before the face.
  [[nodiscard]] std::vector<Stretch> seen_along(std::uint32_t face, std::uint32_t a, std::uint32_t b) const;

  /// The seen region of a face as convex polygons without common inside points; empty when nothing is seen.
  [[nodiscard]] std::vector<ExactPolygon> seen_region(std::uint32_t face) const;

  /// The faces of which something is seen, by increasing number. In parallel.
  [[nodiscard]] std::vector<std::uint32_t> seen_faces() const;

 private:
  [[nodiscard]] std::span<const std::uint32_t> before(std::uint32_t face) const {
    return std::span(before_).subspan(first_[face], first_[face + 1] - first_[face]);
  }
  bool hides(std::uint32_t piece, std::uint32_t face, std::uint32_t a, std::uint32_t b, Stretch& hidden) const;
  [[nodiscard]] std::vector<RationalPlane> shadow(std::uint32_t piece, std::uint32_t face) const;
  [[nodiscard]] bool covers(std::uint32_t piece, std::uint32_t face) const;

  LayerDecomposition decomposition_;
  Sight sight_;
  std::vector<std::uint32_t> first_, before_;  ///< per face, the pieces that come before some of it
};

}  // namespace strata
