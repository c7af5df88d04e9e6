#pragma once
#include <array>
#include <cstddef>
#include <span>

#include "core/kernel/point.h"

namespace strata {

/// Source planes that contain a point, as its name and its defining features show. They are certain, but may not be
/// all.
class KnownPlanes {
 public:
  KnownPlanes(const InputComplex& input, const Point& p);

  [[nodiscard]] std::span<const SourcePlane* const> list() const { return {planes_.data(), count_}; }
  [[nodiscard]] bool has(const SourcePlane* plane) const;

 private:
  void add(const SourcePlane* plane);
  void add_face(std::uint32_t f) { add(input_.source_plane(f)); }
  void add_edge(std::uint32_t a, std::uint32_t b);

  const InputComplex& input_;
  std::array<const SourcePlane*, 6> planes_{};
  std::size_t count_ = 0;
};

}  // namespace strata
