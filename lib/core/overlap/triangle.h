#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "core/exact/sign.h"
#include "core/kernel/input_complex.h"
#include "core/kernel/point.h"

namespace strata {

/// A feature of a triangle: vertex i, edge i (from vertex i to the next), or the interior.
struct Feature {
  enum class Kind : std::uint8_t { vertex, edge, face };
  Kind kind = Kind::face;
  std::uint8_t index = 0;

  static constexpr Feature vertex(int i) { return {Kind::vertex, static_cast<std::uint8_t>(i)}; }
  static constexpr Feature edge(int i) { return {Kind::edge, static_cast<std::uint8_t>(i)}; }
  static constexpr Feature inside() { return {Kind::face, 0}; }
  friend constexpr bool operator==(Feature, Feature) = default;
};

using Signs = std::array<Sign, 3>;

inline constexpr int next(int i) { return i == 2 ? 0 : i + 1; }
inline constexpr int previous(int i) { return i == 0 ? 2 : i - 1; }

/// The feature of a triangle that contains a point of its plane, from the point's sides of the three directed edges;
/// nullopt when the point is outside. `inner` is the sign of the inner side.
[[nodiscard]] std::optional<Feature> locate(const Signs& sides, Sign inner);

/// The same when the orientation is not known: the interior where no two sides differ.
[[nodiscard]] std::optional<Feature> locate(const Signs& sides);

/// A point in which triangles f and g meet: its lowest-dimensional feature of each.
struct SharedPoint {
  Feature on_f, on_g;
  friend constexpr bool operator==(SharedPoint, SharedPoint) = default;
};

/// Name of a shared point, as seen from f: where both features are vertices, f's vertex. Requires that not both
/// features are interiors.
[[nodiscard]] SymbolicPoint name_of(SharedPoint p, std::uint32_t f, const InputComplex::Indices& vf, std::uint32_t g,
                                    const InputComplex::Indices& vg);

}  // namespace strata
