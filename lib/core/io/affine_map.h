#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "strata/mesh.h"
#include "strata/rational.h"

namespace strata::io {

/// Rows of an affine map, exact, so that chains of nodes do not round at every step.
struct ExactMap {
  std::array<std::array<Rational, 4>, 3> rows;
  bool is_rounded = false;  ///< an entry was rounded, to at least 100 bits

  [[nodiscard]] static ExactMap identity();
  [[nodiscard]] bool is_identity() const;
};

/// First `inner`, then `outer`. Entries that are no sums of two doubles, of like size, are rounded to such. Throws
/// Malformed for entries beyond the range of doubles.
[[nodiscard]] ExactMap product(const ExactMap& outer, const ExactMap& inner);

/// An affine map for many points. Every image is the exact one, rounded to the nearest double: entries are sums of two
/// doubles and their products are summed in twice the precision, so in rare cases of a near tie, to the second nearest.
class PointMap {
 public:
  explicit PointMap(const ExactMap& map);

  /// Maps a point; `is_rounded` becomes true if its image is not three doubles.
  [[nodiscard]] Vertex operator()(const Vertex& p, bool& is_rounded) const;
  /// A direction that is normal to a surface, mapped as normals are, of length 1.
  [[nodiscard]] Vertex normal(const Vertex& n) const;
  [[nodiscard]] bool is_identity() const { return is_identity_; }
  /// Does it turn the inside of a surface out?
  [[nodiscard]] bool mirrors() const { return mirrors_; }

 private:
  std::array<std::array<double, 4>, 3> high_{}, low_{};  ///< rows; an entry is the sum of both
  std::array<std::array<double, 3>, 3> cofactors_{};
  bool is_identity_;
  bool mirrors_;
  bool is_rounded_;
};

}  // namespace strata::io
